// SPDX-License-Identifier: MIT
#pragma once

#include "core/time.hpp"

namespace fantail::core {

constexpr Microseconds one_ms{1'000};

constexpr Microseconds ms(int value) { return Microseconds{value * 1'000LL}; }

}  // namespace fantail::core
