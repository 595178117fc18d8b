// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/scenario.hpp"

namespace fantail::stability {

/// The roll loop at one air speed, opened at the servo command:
///   L(s) = (kp + kd s) b / (s (s + a)) e^(-delay s) / (1 + lag s) (1 - wash e^(-wash_delay s)).
struct RollLoop {
  double proportional_gain = 0.0;   ///< kp, not negative
  double derivative_gain_s = 0.0;   ///< kd, not negative
  double damping_rate_per_s = 0.0;  ///< a: how fast the air ends a roll rate
  double authority_per_s2 = 0.0;    ///< b: roll acceleration per radian of canard
  double servo_lag_s = 0.0;
  double delay_s = 0.0;
  double slow_share = 0.0;  ///< of the canards: their lag is sim::slow_times as long
  double wash = 0.0;        ///< share of the canards' torque that the fins take back, see sim::FinWash
  double wash_delay_s = 0.0;
};

/// How far a loop is from oscillating.
struct Margins {
  double phase_margin_rad;            ///< below zero: it swings
  double crossover_rad_s;             ///< where the loop's gain is one
  std::optional<double> gain_margin;  ///< the factor on the gains at which it begins to swing; empty: no factor does
};

/// Empty when the gain never reaches one, as with gains of zero: nothing can swing then. Empty too where the fins take
/// back all of the torque or more: such a loop holds nothing, whatever its gains. Where the fins' answer makes the gain
/// pass one several times, the pass with the least phase margin counts.
[[nodiscard]] std::optional<Margins> margins(const RollLoop& loop);

/// Of the two the phase margin alone: cheap enough to try thousands of gains with.
[[nodiscard]] std::optional<double> phase_margin_rad(const RollLoop& loop);

/// All dead time between a roll rate and the canard that answers it: the gyro's, the wait for the next pulse frame and
/// its hold, and the servo's own.
[[nodiscard]] double loop_delay_s(const sim::Vehicle& vehicle);

/// The loop of a scenario with its own airframe, in the air at the launch site, and with the canard faults that are
/// there at lift-off.
[[nodiscard]] RollLoop loop_at_speed(const sim::Scenario& scenario, double speed_m_s);

}  // namespace fantail::stability
