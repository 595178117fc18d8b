// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {
namespace {

FlightPlan flies_on_two() {
  FlightPlan plan = default_plan();
  plan.sensors.gyros = GyroRule::two_agree;
  plan.sensors.gyro_disagreement_rad_s = 0.25F;
  plan.motion.stale_time = Microseconds{5'000};
  return plan;
}

/// An estimator that follows two gyros, once a millisecond.
class TwoGyros {
 public:
  GyroSample at(float roll_rate_rad_s, int age_us = 0) const {
    return {.time = now - Microseconds{age_us},
            .rate_rad_s = {roll_rate_rad_s, 0.0F, 0.0F},
            .quality = SampleQuality::valid};
  }
  GyroVote tick(const GyroSample& first, const GyroSample& second) {
    Inputs inputs;
    inputs.time = now;
    inputs.gyro = first;
    inputs.second_gyro = second;
    estimator.update(inputs);
    now += Microseconds{1'000};
    return estimator.gyro_vote();
  }
  [[nodiscard]] Motion motion() const { return estimator.motion(now); }

  Microseconds now{10'000};
  MotionEstimator estimator{flies_on_two().motion, flies_on_two().sensors};
};

TEST(MotionGyros, OneThatIsOlderThanTheOtherByMoreThanHalfTheStaleTimeIsNotFlownOn) {
  TwoGyros gyros;
  EXPECT_EQ(gyros.tick(gyros.at(1.0F, 2'500), gyros.at(1.0F)), GyroVote::both);
  EXPECT_EQ(gyros.tick(gyros.at(1.0F, 2'501), gyros.at(1.0F)), GyroVote::second);
}

TEST(MotionGyros, TheVeryFirstSampleOnThePadSaysWhatTheSecondReadsMore) {
  TwoGyros gyros;
  EXPECT_EQ(gyros.tick(gyros.at(0.25F), gyros.at(0.375F)), GyroVote::both);
  EXPECT_EQ(gyros.tick({}, gyros.at(0.375F)), GyroVote::second);
  EXPECT_EQ(gyros.motion().roll_rate_rad_s, 0.25F);
}

TEST(MotionGyros, OneThatSaysZeroFromTheBeginningIsBelievedForEightSamplesAndNotForTen) {
  TwoGyros gyros;
  for (int i = 1; i <= 10; ++i) {
    const GyroVote vote = gyros.tick(gyros.at(0.0F), gyros.at(i % 2 == 0 ? 0.1F : -0.1F));
    if (i <= 8 || i == 10) {
      EXPECT_EQ(vote, i <= 8 ? GyroVote::both : GyroVote::second) << i;
    }
  }
}

TEST(MotionGyros, BeforeTheFirstSampleNothingIsKnownAndNothingIsBridgedOrABound) {
  TwoGyros gyros;
  const Motion motion = gyros.motion();
  EXPECT_EQ(motion.gyro, SensorState::failed);
  EXPECT_EQ(motion.accelerometer, SensorState::failed);
  EXPECT_EQ(motion.roll_angle, Angle{});
  EXPECT_EQ(motion.roll_rate_rad_s, 0.0F);
  EXPECT_EQ(motion.specific_force_m_s2.x, 0.0F);
  EXPECT_EQ(motion.height_m, 0.0F);
  EXPECT_EQ(motion.distance_along_guide_m, 0.0F);
  EXPECT_EQ(motion.speed_m_s, 0.0F);
  EXPECT_EQ(motion.vertical_speed_m_s, 0.0F);
  EXPECT_NEAR(motion.tilt.radians(), 0.0F, 1e-7F) << "upright until the pad says otherwise";
  EXPECT_FALSE(motion.rate_is_lower_bound);
  EXPECT_FALSE(motion.roll_is_bridged);
  EXPECT_FALSE(motion.speed_is_lower_bound);
  EXPECT_EQ(motion.at_rest_for, Microseconds{0});
  EXPECT_EQ(gyros.estimator.gyro_vote(), GyroVote::neither);
}

}  // namespace
}  // namespace fantail::core
