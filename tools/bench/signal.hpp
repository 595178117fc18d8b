// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bench/course.hpp"

namespace fantail::bench {

// Small measurements on one stretch of encoder readings. All skip what was not read, and are empty when too little was.

/// Mean of the middle four fifths: a few wild readings do not move it.
[[nodiscard]] std::optional<double> level_rad(const Course& course, const Window& window);

/// A straight line through the readings, and what they do around it.
struct Rest {
  double drift_rad_s = 0.0;
  double variance_rad2 = 0.0;
  double readings = 0.0;
};
[[nodiscard]] std::optional<Rest> rest_of(const Course& course, const Window& window);

/// The steepest straight line through any 11 ms, without sign: how fast the canard ever was.
[[nodiscard]] std::optional<double> fastest_rad_s(const Course& course, const Window& window);

/// Time between 10 and 90 % of the way from one angle to another; negative never. Empty when it does not get there.
[[nodiscard]] std::optional<double> rise_time_s(const Course& course, const Window& window, double from_rad,
                                                double to_rad);

/// Largest absolute value of the mean over 21 ms of (encoder - expected), among ticks whose part passes `wanted`.
[[nodiscard]] std::optional<double> largest_difference_rad(const Course& course,
                                                           const std::vector<double>& expected_rad,
                                                           bool (*wanted)(Part));

}  // namespace fantail::bench
