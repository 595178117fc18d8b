// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "airframe/model/build_up.hpp"
#include "core/flight_plan.hpp"
#include "sim/vehicle.hpp"
#include "stability/gain_choice.hpp"

namespace fantail::airframe {

/// Gains for the first simulated flights of a rocket whose roll model is only computed from its shape.
struct FirstGains {
  stability::Gains gains;
  /// With them the loop has a phase margin of 30 degrees at every speed of a straight ascent, with damping and torque
  /// anywhere in their ranges. If not, no gains that a plan may have do, and these are those of the plan.
  bool reach_phase_margin = false;
  double lowest_speed_m_s = 0.0;  ///< where control may begin
  double highest_speed_m_s = 0.0;
  double servo_lag_s = 0.0;
};

[[nodiscard]] stability::Gains gains_of(const core::FlightPlan& plan);

/// For `vehicle` with the roll model that its shape gives: the gains nearest to those of `plan`. Empty without canards,
/// and where control never begins in a straight ascent.
[[nodiscard]] std::optional<FirstGains> first_gains(const sim::Vehicle& vehicle, const model::BuildUp& computed,
                                                    const core::FlightPlan& plan);

/// Why a rocket with canards has none, for a person.
[[nodiscard]] std::string why_none(const core::FlightPlan& plan);

/// What was asked of them, for a person.
[[nodiscard]] std::string sentence(const FirstGains& first);

}  // namespace fantail::airframe
