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

/// A detector that is given samples as large as they can be.
class Bound {
 public:
  Bound(const core::LaunchDetectionPlan& plan, float first)
      : plan_{plan},
        share_{plan.low_pass ? core::lag_fraction(2.0F * std::numbers::pi_v<float> * plan.low_pass_hz *
                                                  static_cast<float>(step_s))
                             : 1.0F},
        filtered_{first} {}

  /// True when the hold may be complete. `anew`: the detector may have begun with this sample.
  bool take(float sample, float range, bool anew) {
    filtered_ += share_ * (sample - filtered_);
    filtered_ = anew ? std::max(filtered_, sample) : filtered_;
    const bool is_above = filtered_ + margin_m_s2 >= plan_.threshold_m_s2 || sample >= range;
    above_ = is_above ? above_ + core::Microseconds{1'000} : core::Microseconds{-1'000};
    return above_ >= plan_.hold;
  }

 private:
  const core::LaunchDetectionPlan& plan_;
  float share_;
  float filtered_;
  core::Microseconds above_{-1'000};
};

}  // namespace

Screened screened(const core::FlightPlan& flight_plan, const Motion& motion, const Readings& readings) {
  const core::LaunchDetectionPlan& plan = flight_plan.launch_detection;
  const auto first_rest = static_cast<std::size_t>(flight_plan.motion.rest_time / core::Microseconds{1'000});
  const Screened unknown = motion.length > first_rest ? Screened::law_decides : Screened::detector_decides;
  const SensorErrors& errors = readings.errors;
  const std::optional<std::size_t> which = one_that_decides(plan, errors);
  if (!which || (*which == errors.bad && errors.condition == Condition::saturated)) {
    return unknown;
  }
  const float range = accelerometer_range_m_s2[*which];
  const float bias = errors.bias_m_s2[*which].x;
  const float noise = force_noise_m_s2 * largest_gaussian + margin_m_s2;
  if (readings.smallest_felt_m_s2 + bias - noise <= -range) {
    return unknown;
  }
  const float most = bias + noise;
  if (readings.largest_felt_m_s2 + most < plan.threshold_m_s2) {
    return Screened::quiet;
  }
  const Said said = said_by(*which, errors, motion.length);
  const float kept = 1.0F - motion.trouble.low_share;  // one that reads low is less negative, too
  const auto sample_at = [&](std::size_t i) {
    const float felt = readings.felt_m_s2[std::min(i, said.stands_from)];
    return std::min(std::max(felt, kept * felt) + most, range);
  };
  // Of what a filter had before it was shut off, so little is left by the first sample after a rest.
  const float rest_s = static_cast<float>(first_rest) * static_cast<float>(step_s);
  const float left =
      plan.low_pass ? range * (1.0F - core::lag_fraction(2.0F * std::numbers::pi_v<float> * plan.low_pass_hz * rest_s))
                    : 0.0F;
  Bound always{plan, sample_at(0)};
  Bound anew{plan, sample_at(0)};
  Screened result = Screened::quiet;
  for (std::size_t i = 0; i < said.end; ++i) {
    const float sample = sample_at(i);
    if (result == Screened::quiet && always.take(sample, range, false)) {
      result = Screened::detector_decides;
    }
    if (i >= first_rest && anew.take(sample + left, range, true)) {
      return Screened::law_decides;
    }
  }
  return result;
}

}  // namespace fantail::detection
