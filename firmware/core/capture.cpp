// SPDX-License-Identifier: MIT
#include "core/capture.hpp"

#include <algorithm>

#include "core/finite.hpp"

namespace fantail::core {
namespace {

constexpr float turn_rad = 2.0F * pi;

// An offset close to the limit leaves so little of the canards against it that any turn with it is sooner.
constexpr float largest_share = 0.9F;
constexpr float share_without_model = 0.5F;

// More turns than any rocket makes; a float has them exactly.
constexpr float most_turns = 10'000.0F;

// Written out: no two C libraries need agree on a half.
float nearest_whole(float value) {
  const float bounded = is_finite(value) ? std::clamp(value, -most_turns, most_turns) : 0.0F;
  return static_cast<float>(static_cast<std::int32_t>(bounded < 0.0F ? bounded - 0.5F : bounded + 0.5F));
}

}  // namespace

Capture::Capture(const FlightPlan& plan)
    : has_model_{plan.roll_model.torque_m > 0.0F},
      canard_limit_{plan.controller.canard_limit},
      stop_without_model_s_{plan.controller.derivative_gain_s / plan.controller.proportional_gain},
      stop_distance_m_{
          2.0F * plan.roll_model.roll_inertia_kg_m2 /
          (plan.roll_model.density_kg_m3 * plan.roll_model.reference_area_m2 * plan.roll_model.damping_m2)},
      damping_per_torque_m_{plan.roll_model.damping_m2 / plan.roll_model.torque_m},
      observer_{plan.offset, plan.roll_model} {}

bool Capture::tells_offset(const Motion& motion) const {
  const bool measures = motion.gyro == SensorState::fresh || motion.gyro == SensorState::coasting;
  return has_model_ && measures && !motion.rate_is_lower_bound && !motion.speed_is_lower_bound &&
         motion.speed_m_s >= slowest_observed_m_s;
}

Angle Capture::kept_up_by(const Motion& motion) const {
  return Angle::from_radians(damping_per_torque_m_ * motion.roll_rate_rad_s / motion.speed_m_s);
}

void Capture::watch(const Motion& motion) {
  if (!tells_offset(motion)) {
    interrupt();
    return;
  }
  if (!offset_) {
    offset_ = kept_up_by(motion);
  } else if (last_rate_rad_s_) {
    const Angle observed =
        observer_.observed(*offset_, Angle{}, *last_rate_rad_s_, motion.roll_rate_rad_s, motion.speed_m_s);
    offset_ = is_finite(observed.radians()) ? observed : *offset_;
  }
  last_rate_rad_s_ = motion.roll_rate_rad_s;
}

// Meets CAP-1.
Angle Capture::begin(const Motion& motion, Angle reference) {
  const float rate_rad_s = motion.roll_rate_rad_s;
  if (!offset_ && tells_offset(motion)) {
    offset_ = kept_up_by(motion);
  }
  const bool knows_speed = has_model_ && !motion.speed_is_lower_bound && motion.speed_m_s >= slowest_observed_m_s;
  const float stop_s = knows_speed ? stop_distance_m_ / motion.speed_m_s : stop_without_model_s_;
  const float share = offset_ ? std::clamp(offset_->radians() / canard_limit_.radians(), -largest_share, largest_share)
                      : rate_rad_s > 0.0F ? share_without_model
                      : rate_rad_s < 0.0F ? -share_without_model
                                          : 0.0F;
  const float ahead_rad = motion.roll_angle.radians() + stop_s * rate_rad_s + pi * share - reference.radians();
  interrupt();
  return Angle::from_radians(turn_rad * nearest_whole(ahead_rad / turn_rad));
}

}  // namespace fantail::core
