// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "stability/roll_loop.hpp"

namespace fantail::tune {

/// How far a step of the reference has been followed, after every millisecond: 0 to begin with, 1 in the end. The
/// linear loop at its one speed, without noise, play or limits.
[[nodiscard]] std::vector<double> step_response(const stability::RollLoop& loop, double duration_s);

/// How long after a step of the reference the roll angle stays within a tenth of the step of it. Empty: longer than
/// `longest_s`, or never.
[[nodiscard]] std::optional<double> settling_s(const stability::RollLoop& loop, double longest_s);

}  // namespace fantail::tune
