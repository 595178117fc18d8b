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

Inputs on_the_pad(Microseconds measured, float roll_rate_rad_s, float across_m_s2) {
  Inputs inputs;
  inputs.time = measured;
  inputs.gyro = {.time = measured, .rate_rad_s = {roll_rate_rad_s, 0.0F, 0.0F}, .quality = SampleQuality::valid};
  inputs.accelerometers.fill(
      {.time = measured, .specific_force_m_s2 = {0.0F, across_m_s2, 0.0F}, .quality = SampleQuality::valid});
  return inputs;
}

TEST(MotionOnThePad, TheFirstBiasOfAllIsTheMeanOfTheFirstThreeSeconds) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 3'501; ++t) {
    estimator.update(on_the_pad(Microseconds{t * 1'000}, 0.015625F, standard_gravity_m_s2));
  }
  EXPECT_NEAR(estimator.motion(Microseconds{3'501'000}).roll_rate_rad_s, 0.0F, 1e-7F);
}

// As in PadWindow.AStepOfTheForceIsMotionWhenItsSquareHasComeThroughALowPassOf16Hertz. The step of a second is of a
// hundred time constants.
TEST(MotionOnThePad, AStepOfTheForceIsMotionWhenItsSquareHasComeThroughALowPassOf16Hertz) {
  MotionPlan plan = default_plan().motion;
  plan.rest_tolerance_m_s2 = 0.1F * standard_gravity_m_s2;
  for (const Microseconds step : {Microseconds{1'770}, Microseconds{1'880}, Microseconds{1'000'000}}) {
    MotionEstimator estimator{plan};
    estimator.update(on_the_pad(Microseconds{0}, 0.0F, standard_gravity_m_s2));
    estimator.update(on_the_pad(step, 0.0F, 1.5F * standard_gravity_m_s2));
    const bool rests = estimator.motion(step + Microseconds{1}).at_rest_for > Microseconds{0};
    EXPECT_EQ(rests, step < Microseconds{1'820}) << step.count();
  }
}

TEST(MotionOnThePad, InNoTimeNoForceComesThroughTheLowPass) {
  MotionEstimator estimator{default_plan().motion};
  Inputs inputs = on_the_pad(Microseconds{500}, 0.0F, standard_gravity_m_s2);
  inputs.time = Microseconds{1'000};
  estimator.update(inputs);
  estimator.update(on_the_pad(Microseconds{1'000}, 0.0F, 3.0F * standard_gravity_m_s2));
  EXPECT_EQ(estimator.motion(Microseconds{2'000}).at_rest_for, Microseconds{1'000});
}

}  // namespace
}  // namespace fantail::core
