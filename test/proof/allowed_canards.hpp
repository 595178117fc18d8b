// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::proof {

/// What the proofs of the mixer take for granted of a plan: the ranges of core/flight_plan_table.hpp and the rules
/// across fields, a little wider where degrees become radians. No plan that passes validate() may break this:
/// ProofRanges in test/core draws such plans.
inline bool is_allowed(const core::CanardsPlan& plan, core::Angle plan_limit) {
  using core::Angle;
  bool all_fit = true;
  for (const core::CanardPlan& canard : plan.each) {
    all_fit = all_fit && abs(canard.trim) < plan_limit && abs(canard.trim) <= Angle::from_degrees(5.01F) &&
              canard.mechanical_stop >= plan_limit && canard.mechanical_stop <= Angle::from_degrees(45.01F) &&
              canard.pulse_centre_us >= 900.0F && canard.pulse_centre_us <= 2100.0F &&
              canard.pulse_per_radian_us >= -2292.0F && canard.pulse_per_radian_us <= 2292.0F;
  }
  return all_fit && plan_limit >= Angle::from_degrees(0.49F) && plan_limit <= Angle::from_degrees(20.01F) &&
         plan.first_motion_rate_rad_s >= 0.087F && plan.first_motion_rate_rad_s <= 2.1F;
}

}  // namespace fantail::proof
