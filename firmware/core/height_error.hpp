// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// By how much height and vertical speed, integrated from an accelerometer since first thrust, may be wrong, at most.
struct MotionError {
  float height_m;
  float vertical_speed_m_s;
};

/// `plan`: what its accelerometer may be wrong by. The scale error counts on all that the accelerometer felt, which is
/// the motion and the fall that it does not feel: h + g t^2 / 2. At rest a zero error looks like a tilt, of root 2
/// times as much with one on both axes across; what the rocket has gone to the side, that tilt takes for height.
[[nodiscard]] inline MotionError motion_error(const DormancyPlan& plan, Microseconds now, const Motion& motion) {
  const float flown_s = seconds(now - motion.thrust_since);
  const float fallen_m = 0.5F * flown_s * flown_s;
  const float tilt_error = 1.4143F / standard_gravity_m_s2 * plan.bias_error_m_s2;
  return {.height_m = plan.scale_error * (motion.height_m + standard_gravity_m_s2 * fallen_m) +
                      plan.bias_error_m_s2 * fallen_m + tilt_error * motion.horizontal_distance_m,
          .vertical_speed_m_s = plan.scale_error * (motion.vertical_speed_m_s + standard_gravity_m_s2 * flown_s) +
                                plan.bias_error_m_s2 * flown_s};
}

}  // namespace fantail::core
