// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace fantail::predict {

/// The roll loop at one air speed, opened at the servo command:
///   L(s) = (kp + kd s) b / (s (s + a)) e^(-delay s) / (1 + lag s).
struct RollLoop {
  double proportional_gain = 0.0;   ///< kp, not negative
  double derivative_gain_s = 0.0;   ///< kd, not negative
  double damping_rate_per_s = 0.0;  ///< a: how fast the air ends a roll rate
  double authority_per_s2 = 0.0;    ///< b: roll acceleration per radian of canard
  double servo_lag_s = 0.0;
  double delay_s = 0.0;
};

/// How far a loop is from swinging by itself.
struct Margins {
  double phase_margin_rad;            ///< below zero: it swings
  double crossover_rad_s;             ///< where the loop's gain is one
  std::optional<double> gain_margin;  ///< the factor on the gains at which it begins to swing; empty: no factor does
};

/// Empty when the gain never reaches one, as with gains of zero: nothing can swing then.
[[nodiscard]] std::optional<Margins> margins(const RollLoop& loop);

}  // namespace fantail::predict
