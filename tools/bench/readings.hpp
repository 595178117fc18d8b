// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "bench/trace.hpp"

namespace fantail::bench {

// Small measurements on one stretch of encoder readings. All skip what was not read, and are empty when too little was.

/// Mean of the middle four fifths: a few wild readings do not move it.
[[nodiscard]] std::optional<double> level_rad(const CanardTrace& trace, const Window& window);

/// A straight line through the readings of a window, over x(i): least squares.
struct LineFit {
  double slope = 0.0;
  double variance = 0.0;   ///< of x
  double left_over = 0.0;  ///< sum of the squares that the line does not explain
  double readings = 0.0;
};
[[nodiscard]] LineFit fit_line(const CanardTrace& trace, const Window& window, auto x) {
  double n = 0.0;
  double sum_x = 0.0;
  double sum_e = 0.0;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (!std::isnan(trace.encoder_rad[i])) {
      n += 1.0;
      sum_x += x(i);
      sum_e += trace.encoder_rad[i];
    }
  }
  double xx = 0.0;
  double xe = 0.0;
  double ee = 0.0;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (const double e = trace.encoder_rad[i] - sum_e / n; !std::isnan(e)) {
      const double centred = x(i) - sum_x / n;
      xx += centred * centred;
      xe += centred * e;
      ee += e * e;
    }
  }
  return xx > 0.0 ? LineFit{.slope = xe / xx, .variance = xx / n, .left_over = ee - xe * xe / xx, .readings = n}
                  : LineFit{};
}

/// Drift and noise around a straight line over time.
struct Rest {
  double drift_rad_s = 0.0;
  double drift_error_rad_s = 0.0;  ///< standard error
  double variance_rad2 = 0.0;
  double readings = 0.0;
};
[[nodiscard]] std::optional<Rest> rest_of(const CanardTrace& trace, const Window& window);

/// The steepest straight line through any 11 ms, without sign: how fast the canard ever was.
[[nodiscard]] std::optional<double> fastest_rad_s(const CanardTrace& trace, const Window& window);

/// Time between 10 and 90 % of the way from one angle to another; negative never. Empty when it does not get there.
[[nodiscard]] std::optional<double> rise_time_s(const CanardTrace& trace, const Window& window, double from_rad,
                                                double to_rad);

/// Largest absolute value of the mean over 21 ms of (encoder - expected), among ticks whose part passes `wanted`.
[[nodiscard]] std::optional<double> largest_difference_rad(const CanardTrace& trace,
                                                           const std::vector<double>& expected_rad,
                                                           bool (*wanted)(Part));

/// Root mean square of (encoder - expected) over all ticks that were read and whose part passes `wanted`.
[[nodiscard]] std::optional<double> rms_difference_rad(const CanardTrace& trace,
                                                       const std::vector<double>& expected_rad, bool (*wanted)(Part));

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

/// The delay (to 40 ms) and lag (1 to 500 ms) with which this trace's encoder is best explained over `window`. Empty
/// when too little was read, the command did not change, or the encoder does not follow it at all.
[[nodiscard]] std::optional<LagFit> fit_lag(const CanardTrace& trace, const Window& window);

/// Slope of the encoder against an already lagged command, and what is left; empty when too little was read.
[[nodiscard]] std::optional<LagFit> regress(const std::vector<double>& lagged_rad, const CanardTrace& trace,
                                            const Window& window);

}  // namespace fantail::bench
