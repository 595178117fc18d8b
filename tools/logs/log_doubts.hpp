// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "logs/roll_log.hpp"

namespace fantail::logs {

// What is legal but most likely not meant. Each doubt becomes a warning of the log; nothing is refused or changed.

/// Without its sign; what is not a number does not count, and of nothing it is 0.
[[nodiscard]] double largest(const std::vector<double>& list);

/// Angles whose size speaks for another unit in the file than the one that `reading` states, and samples so far apart
/// that time is likely in milliseconds.
void note_doubtful_units(RollLog& log, const Reading& reading);

/// A roll rate that is not the slope of the roll angle: of opposite sign, or off by 180 / pi.
void note_doubtful_motion(RollLog& log);

}  // namespace fantail::logs
