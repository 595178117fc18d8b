// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flight_plan_fields.hpp"
#include "core/launch_detector.hpp"
#include "milliseconds.hpp"

namespace fantail::core {

inline constexpr float g = standard_gravity_m_s2;
inline constexpr Microseconds stale_time{5'000};

inline LaunchDetectionPlan launch_1_rule() {
  LaunchDetectionPlan plan = default_plan().launch_detection;
  plan.threshold_m_s2 = 2.0F * g;
  plan.hold = ms(200);
  plan.accelerometers = AccelerometerRule::one;
  plan.low_pass = false;
  return plan;
}

inline LaunchDetectionPlan launch_2_rule() {
  LaunchDetectionPlan plan = default_plan().launch_detection;
  plan.threshold_m_s2 = 2.5F * g;
  plan.hold = ms(100);
  plan.accelerometers = AccelerometerRule::two_agree;
  plan.low_pass = false;
  return plan;
}

inline AccelerometerSample sample(Microseconds time, float axial_g, SampleQuality quality = SampleQuality::valid) {
  return {.time = time, .specific_force_m_s2 = {axial_g * g, 0.0F, 0.0F}, .quality = quality};
}

/// Feeds both accelerometers at the same instants.
class Bench {
 public:
  explicit Bench(const LaunchDetectionPlan& plan) : detector_{plan, stale_time} {}

  DetectionState feed(Microseconds time, float axial_g) { return feed(time, axial_g, axial_g); }
  DetectionState feed(Microseconds time, float first_g, float second_g) {
    return feed(time, sample(time, first_g), sample(time, second_g));
  }
  DetectionState feed(Microseconds now, const AccelerometerSample& first, const AccelerometerSample& second) {
    return detector_.update(now, {first, second});
  }

  bool agrees(Microseconds time, float first_g, float second_g) {
    return agrees(time, sample(time, first_g), sample(time, second_g));
  }
  bool agrees(Microseconds now, const AccelerometerSample& first, const AccelerometerSample& second) {
    return detector_.agrees(now, {first, second});
  }

  void reset() { detector_.reset(); }

  /// 1 kHz from `begin` on, exclusive of `end`; when it fired, if it did.
  std::optional<Microseconds> hold_level(Microseconds begin, Microseconds end, float axial_g) {
    std::optional<Microseconds> fired;
    for (Microseconds t = begin; t < end; t += ms(1)) {
      if (feed(t, axial_g) == DetectionState::detected && !fired) {
        fired = t;
      }
    }
    return fired;
  }

 private:
  LaunchDetector detector_;
};

}  // namespace fantail::core
