// SPDX-License-Identifier: MIT
#include "detection/screen.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>

#include "core/low_pass.hpp"
#include "detection/shapes.hpp"

namespace fantail::detection {
namespace {

// The far tail of sim::Random begins at 3.6542 and is thinned by two draws of an exponential law, of which none is
// beyond 53 ln 2: 2 * 53 ln 2 > x^2 holds for no x beyond 8.5717.
constexpr float largest_gaussian = 12.23F;
// What the product's arithmetic may differ by, many times over.
constexpr float margin_m_s2 = 0.01F;

/// An accelerometer whose hold must be complete for the rule to fire; empty where that may be the other one's instead.
std::optional<std::size_t> one_that_decides(const core::LaunchDetectionPlan& plan, const SensorErrors& errors) {
  const std::size_t well = errors.condition != Condition::well && errors.bad == 0 ? 1 : 0;
  if (plan.accelerometers == core::AccelerometerRule::one) {
    return 0;
  }
  return plan.single_allowed ? std::nullopt : std::optional{well};
}

/// Where a bad one stands still, and until when it says anything. Of a dead one this is more than it says.
struct Said {
  std::size_t stands_from;
  std::size_t end;
};
Said said_by(std::size_t which, const SensorErrors& errors, std::size_t length) {
  if (which == errors.bad && errors.condition == Condition::stuck) {
    return {errors.onset, length};
  }
  if (which == errors.bad && errors.condition == Condition::frozen) {
    return {errors.onset, std::min(length, errors.onset + frozen_unnoticed[which])};
  }
  return {length, length};
}

}  // namespace

bool may_fire(const core::LaunchDetectionPlan& plan, const Motion& motion, const Readings& readings) {
  const SensorErrors& errors = readings.errors;
  const std::optional<std::size_t> which = one_that_decides(plan, errors);
  if (!which || (*which == errors.bad && errors.condition == Condition::saturated)) {
    return true;
  }
  const float range = accelerometer_range_m_s2[*which];
  const float bias = errors.bias_m_s2[*which].x;
  const float noise = force_noise_m_s2 * largest_gaussian + margin_m_s2;
  if (readings.smallest_felt_m_s2 + bias - noise <= -range) {
    return true;
  }
  const float most = bias + noise;
  if (readings.largest_felt_m_s2 + most < plan.threshold_m_s2) {
    return false;
  }
  const float share =
      plan.low_pass
          ? core::lag_fraction(2.0F * std::numbers::pi_v<float> * plan.low_pass_hz * static_cast<float>(step_s))
          : 1.0F;
  const Said said = said_by(*which, errors, motion.length);
  float filtered = std::min(readings.felt_m_s2[0] + most, range);
  core::Microseconds above{-1'000};
  for (std::size_t i = 0; i < said.end; ++i) {
    const float sample = std::min(readings.felt_m_s2[std::min(i, said.stands_from)] + most, range);
    filtered += share * (sample - filtered);
    const bool is_above = filtered + margin_m_s2 >= plan.threshold_m_s2 || sample >= range;
    above = is_above ? above + core::Microseconds{1'000} : core::Microseconds{-1'000};
    if (above >= plan.hold) {
      return true;
    }
  }
  return false;
}

}  // namespace fantail::detection
