// SPDX-License-Identifier: MIT
#pragma once

#include "core/canard_mixer.hpp"
#include "proof.hpp"

namespace fantail::proof {

/// The canards of any plan that has passed validate(), and its plan limit. The ranges are those of
/// core/flight_plan_table.hpp and of check_across_fields(), a little wider where degrees become radians;
/// plan_ranges_test.cpp holds them against validate().
struct AnyCanards {
  core::CanardsPlan plan{};
  core::Angle plan_limit = any_angle();

  AnyCanards() {
    using core::Angle;
    assume(plan_limit >= Angle::from_degrees(0.49F) && plan_limit <= Angle::from_degrees(20.01F));
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      core::CanardPlan& canard = plan.each[i];
      canard.direction = any_of<core::Direction>(2);
      canard.trim = any_angle();
      canard.mechanical_stop = any_angle();
      canard.pulse_centre_us = nondet_float();
      canard.pulse_per_radian_us = nondet_float();
      assume(abs(canard.trim) < plan_limit && abs(canard.trim) <= Angle::from_degrees(5.01F));
      assume(canard.mechanical_stop >= plan_limit && canard.mechanical_stop <= Angle::from_degrees(45.01F));
      assume(canard.pulse_centre_us >= 900.0F && canard.pulse_centre_us <= 2100.0F);
      assume(canard.pulse_per_radian_us >= -2292.0F && canard.pulse_per_radian_us <= 2292.0F);
    }
    plan.first_motion_rate_rad_s = nondet_float();
    assume(plan.first_motion_rate_rad_s >= 0.087F && plan.first_motion_rate_rad_s <= 2.1F);
  }
};

inline core::EncoderAngles any_encoders() {
  return {any_optional_angle(), any_optional_angle(), any_optional_angle(), any_optional_angle()};
}

inline std::optional<std::array<core::Angle, core::canard_count>> any_request() {
  if (nondet_bool()) {
    return std::array<core::Angle, core::canard_count>{any_angle(), any_angle(), any_angle(), any_angle()};
  }
  return std::nullopt;
}

}  // namespace fantail::proof
