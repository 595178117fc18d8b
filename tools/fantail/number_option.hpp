// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// Both ends included. The library's own range would take "nan".
[[nodiscard]] Objection within(double low, double high);

}  // namespace fantail::tool
