// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/scenario.hpp"

namespace fantail::stability {

/// The law's own model of the rocket, and how fast it follows the offset by it; see core::DisturbanceObserver.
struct ObserverModel {
  double bandwidth_rad_s = 0.0;     ///< w; zero: the law does not observe
  double damping_rate_per_s = 0.0;  ///< a_m at this speed
  double authority_per_s2 = 1.0;    ///< b_m, above zero
};

/// The roll loop at one air speed, opened at the servo command, with f the factor of the gain schedule:
///   L(s) = (f kp + f ki / s + f kd s) b / (s (s + a)) H(s),
///   H(s) = e^(-delay s) / (1 + lag s) (1 - wash e^(-wash_delay s)).
/// An observer's estimate d = w / (s + w) ((s + a_m) p / b_m - u) goes off the command u: with u on one side that is
///   L(s) = ((f kp / s + f kd) (1 + w / s) + w (s + a_m) / (b_m s)) b / (s + a) H(s),
/// the loop of integral action with other gains:
///   kp' = f kp + w (f kd + a_m / b_m),  ki' = w f kp,  kd' = f kd + w / b_m.
struct RollLoop {
  double proportional_gain = 0.0;    ///< kp, not negative
  double derivative_gain_s = 0.0;    ///< kd, not negative
  double integral_gain_per_s = 0.0;  ///< ki, not negative
  double gain_factor = 1.0;          ///< f, above zero
  ObserverModel observer{};
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
  double phase_margin_rad;  ///< below zero: it swings
  double crossover_rad_s;   ///< where the loop's gain is one
  /// The factor on the gain of the whole loop, which is one on the canards' torque, at which it begins to swing or ends
  /// to; empty: no factor does. Below one where a loop that holds swings with less.
  std::optional<double> gain_margin;
  std::optional<double> half_turn_rad_s;  ///< where the phase is minus half a turn with that gain; empty with it
};

/// What the opened loop makes of a swing.
struct Response {
  double gain;
  double phase_rad;  ///< followed from frequency zero on, not wrapped
};

/// L(i w) of the loop that margins() looks at, at w above zero.
[[nodiscard]] Response response(const RollLoop& loop, double w_rad_s);

/// Empty when the gain never reaches one, as with gains of zero: nothing can swing then. Empty too where the fins take
/// back all of the torque or more: such a loop holds nothing, whatever its gains. Where the fins' answer or an
/// integrator makes the gain pass one several times, the pass with the least phase margin counts.
[[nodiscard]] std::optional<Margins> margins(const RollLoop& loop);

/// Of the two the phase margin alone: cheap enough to try thousands of gains with.
[[nodiscard]] std::optional<double> phase_margin_rad(const RollLoop& loop);

/// All dead time between a roll rate and the canard that answers it: the gyro's, the wait for the next pulse frame and
/// its hold, and the servo's own.
[[nodiscard]] double loop_delay_s(const sim::Vehicle& vehicle);

/// The loop of a scenario with its own airframe and all modes of its plan's law, in the air at the launch site, and
/// with the canard faults that are there at lift-off.
[[nodiscard]] RollLoop loop_at_speed(const sim::Scenario& scenario, double speed_m_s);

}  // namespace fantail::stability
