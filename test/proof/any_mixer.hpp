// SPDX-License-Identifier: MIT
#pragma once

#include "allowed_canards.hpp"
#include "core/canard_mixer.hpp"
#include "proof.hpp"

namespace fantail::proof {

/// The canards of any plan that has passed validate(), and its plan limit.
struct AnyCanards {
  core::CanardsPlan plan{};
  core::Angle plan_limit = any_angle();

  AnyCanards() {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      core::CanardPlan& canard = plan.each[i];
      canard.direction = any_of<core::Direction>(2);
      canard.trim = any_angle();
      canard.mechanical_stop = any_angle();
      canard.pulse_centre_us = nondet_float();
      canard.pulse_per_radian_us = nondet_float();
    }
    plan.first_motion_rate_rad_s = nondet_float();
    assume(is_allowed(plan, plan_limit));
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
