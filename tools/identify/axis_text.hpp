// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "identify/estimate.hpp"

namespace fantail::identify {

/// Reads "FIRST:LAST:STEP": all above zero, last not below first, at most 1000 values. Empty for anything else.
[[nodiscard]] std::optional<Axis> parse_axis(const std::string& text);

}  // namespace fantail::identify
