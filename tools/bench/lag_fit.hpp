// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/course.hpp"

namespace fantail::bench {

/// How an encoder follows a command: slope * lagged(command) + offset, where the command is held back by a delay and a
/// first-order lag.
struct LagFit {
  std::size_t delay_ticks = 0;
  double lag_s = 0.0;
  double slope = 0.0;
  double spread = 0.0;  ///< variance of the encoder that the fit leaves, rad^2

  [[nodiscard]] double total_s() const { return lag_s + static_cast<double>(delay_ticks) * tick_s; }
};

/// The command as such a servo would follow it, from rest at its first value.
[[nodiscard]] std::vector<double> lagged(const std::vector<double>& command_rad, std::size_t delay_ticks, double lag_s);

/// The delay (to 40 ms) and lag (1 to 500 ms) with which this course's encoder is best explained over `window`. Empty
/// when too little was read, the command did not change, or the encoder does not follow it at all.
[[nodiscard]] std::optional<LagFit> fit_lag(const Course& course, const Window& window);

/// Slope of the encoder against an already lagged command, and what is left; empty when too little was read.
[[nodiscard]] std::optional<LagFit> regress(const std::vector<double>& lagged_rad, const Course& course,
                                            const Window& window);

}  // namespace fantail::bench
