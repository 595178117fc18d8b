// SPDX-License-Identifier: MIT
#include "core/offset_estimator.hpp"

#include "core/finite.hpp"

namespace fantail::core {
namespace {

// Longer without a measured rate, and nobody knows what turned the rocket meanwhile.
constexpr Microseconds longest_gap{5'000};

// Slower, and the air tells less of an offset than a gyro makes noise.
constexpr float slowest_observed_m_s = 10.0F;

}  // namespace

OffsetEstimator::OffsetEstimator(const FlightPlan& plan)
    : rejection_{plan.offset.rejection},
      canard_limit_{plan.controller.canard_limit},
      integral_{integral_action(plan.controller, plan.offset)},
      observer_{plan.offset, plan.roll_model} {}

void OffsetEstimator::update(Microseconds now, const Motion& motion, Angle error, float gain_factor) {
  if (rejection_ == OffsetRejection::none || motion.gyro != SensorState::fresh || motion.rate_is_lower_bound) {
    return;
  }
  const bool goes_on = last_time_ < now && last_time_ >= now - longest_gap;
  const float elapsed_s = goes_on ? seconds(now - last_time_) : 0.0F;
  const float last_rate_rad_s = last_rate_rad_s_;
  last_time_ = now;
  last_rate_rad_s_ = motion.roll_rate_rad_s;
  if (!goes_on) {
    return;
  }
  Angle estimate = estimate_;
  if (rejection_ == OffsetRejection::integral) {
    estimate = integrated(integral_, estimate, gain_factor * error, taken_off_, elapsed_s);
  } else if (motion.speed_m_s >= slowest_observed_m_s && !motion.speed_is_lower_bound) {
    estimate =
        observer_.observed(estimate, command_, last_rate_rad_s, motion.roll_rate_rad_s, motion.speed_m_s, elapsed_s);
  }
  if (is_finite(estimate.radians())) {
    estimate_ = clamp(estimate, canard_limit_);
  }
}

}  // namespace fantail::core
