// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "telemetry/receiver.hpp"

namespace fantail::telemetry {

[[nodiscard]] std::string_view name(hal::CanState state);

/// "launched -> controlling (guide_clear)", "canard 3: healthy -> stalled".
[[nodiscard]] std::string words(const Event& event);

}  // namespace fantail::telemetry
