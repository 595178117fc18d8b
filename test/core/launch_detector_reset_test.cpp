// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "core/launch_detector.hpp"

namespace fantail::core {
namespace {

constexpr Microseconds stale_time{5'000};

class LaunchDetectorReset : public ::testing::Test {
 protected:
  LaunchDetectorReset() {
    plan.threshold_m_s2 = 2.0F * standard_gravity_m_s2;
    plan.hold = Microseconds{100'000};
    plan.low_pass = false;
  }
  static DetectionState feed(LaunchDetector& detector, int time_ms, float axial_g) {
    const Microseconds time{time_ms * 1'000};
    const AccelerometerSample sample{time, {axial_g * standard_gravity_m_s2, 0.0F, 0.0F}, SampleQuality::valid};
    return detector.update(time, {sample, sample});
  }

  LaunchDetectionPlan plan = default_plan().launch_detection;
};

TEST_F(LaunchDetectorReset, HoldThatWasAlmostCompleteIsForgotten) {
  LaunchDetector detector{plan, stale_time};
  for (int t = 0; t < 100; ++t) {
    feed(detector, t, 3.0F);
  }
  detector.reset();
  for (int t = 100; t < 200; ++t) {
    ASSERT_EQ(feed(detector, t, 3.0F), DetectionState::holding) << t;
  }
  EXPECT_EQ(feed(detector, 200, 3.0F), DetectionState::detected);
}

TEST_F(LaunchDetectorReset, LowPassIsPrimedByTheFirstSampleAfterIt) {
  plan.low_pass = true;
  LaunchDetector detector{plan, stale_time};
  for (int t = 0; t < 90; ++t) {
    feed(detector, t, 16.0F);
  }
  detector.reset();
  EXPECT_EQ(feed(detector, 90, 1.0F), DetectionState::quiet);
}

}  // namespace
}  // namespace fantail::core
