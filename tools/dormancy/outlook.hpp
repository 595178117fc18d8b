// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flight_phase.hpp"
#include "dormancy/opening.hpp"
#include "sim/scenario.hpp"

namespace fantail::dormancy {

/// A moment of a simulated ascent, as it truly was.
struct Moment {
  double time_s = 0.0;  ///< after lift-off
  double height_m = 0.0;
  double speed_m_s = 0.0;  ///< through the air, along the axis
};

/// What a launch comes to before its canards may move: the flight code, gate and all, flown once as the scenario
/// stands. Empty: it does not happen, or nobody knows it (the motor of a prescribed path).
struct Outlook {
  std::optional<Moment> guide_clear{};     ///< the rocket truly left it
  std::optional<Moment> thrust_is_drag{};  ///< specific force zero, for the last time before apogee
  std::optional<Moment> last_thrust{};     ///< last_thrust_s()
  std::optional<Moment> thrust_end{};      ///< the end of the thrust curve
  std::optional<Moment> most_pressure{};   ///< largest dynamic pressure
  std::optional<Moment> at_height{};       ///< truly at the height of the plan
  std::optional<Moment> apogee{};
  std::optional<Opening> opening{};  ///< canards leave trim; its clock begins at lift-off
  double top_speed_m_s = 0.0;        ///< before that, or of the whole ascent
  /// Where the canards stayed at trim to the end: why control ended, or what the flight code last waited for.
  std::optional<core::PhaseReason> stayed_because{};
  bool gyro_was_at_its_end = false;  ///< in flight: then no gate opens by height or dynamic pressure

  /// The canards leave trim so long after the last thrust. Below zero: the motor still burns.
  [[nodiscard]] std::optional<double> opens_after_thrust_s() const;
  /// What the plan's height, by its stated errors, is waited for beyond being there.
  [[nodiscard]] std::optional<double> height_costs_s() const;

  /// From first thrust, as the flight code has it, to last: with a burn clock that is no shorter a gate by burn-out
  /// opens in no such flight before it.
  std::optional<double> burn_s{};
};

/// When a motor last pushes with 2 % of its largest thrust, after ignition. Empty without a motor.
[[nodiscard]] std::optional<double> last_thrust_s(const sim::ThrustCurve& motor);

/// Of a launch. The scenario's own seed, wind, faults and imposed roll are flown.
[[nodiscard]] Outlook outlook(const sim::Scenario& scenario);

}  // namespace fantail::dormancy
