// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"
#include "proof.hpp"

namespace fantail::core {

struct MotionError {
  float height_m;
  float vertical_speed_m_s;
};

inline float any_number() {
  const float value = nondet_float();
  proof::assume(value == value);
  return value;
}

/// In the place of what a plan makes of the motion: any error that is a number, the same in a tick. (Of a motion that
/// is no number it is none, but then heights do not agree.)
inline const MotionError any_motion_error{any_number(), any_number()};

inline MotionError motion_error(const DormancyPlan&, Microseconds, const Motion&) { return any_motion_error; }

}  // namespace fantail::core
