// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "motion_flight.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;

Inputs at(Microseconds time, const Vector3& rate_rad_s, float axial_m_s2) {
  Inputs inputs;
  inputs.time = time;
  inputs.gyro = {time, rate_rad_s, SampleQuality::valid};
  inputs.accelerometers.fill({time, {axial_m_s2, 0.0F, 0.0F}, SampleQuality::valid});
  return inputs;
}

TEST(MotionEstimator, TheWindowThatIsReplayedReachesBackOneSecondAndNoMicrosecondMore) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 1'001; ++t) {
    estimator.update(at(ms(t), {}, t == 0 ? g : 3.0F * g));
    // A tenth of the step to 3 g has come through the low-pass after 1.05 ms.
    EXPECT_EQ(estimator.motion(ms(t)).thrust_since, t == 0 ? ms(0) : ms(1)) << t;
  }
  const Microseconds later{1'001'001};
  estimator.update(at(later, {}, 3.0F * g));
  EXPECT_EQ(estimator.motion(later).thrust_since, later);
  EXPECT_EQ(estimator.motion(later).speed_m_s, 0.0F);
}

TEST(MotionEstimator, InTheGuideExactly800MilliGIsStandingAndLessIsNot) {
  for (const bool less : {false, true}) {
    const float axial_m_s2 = less ? std::nextafter(0.8F * g, 0.0F) : 0.8F * g;
    MotionEstimator estimator{default_plan().motion};
    estimator.begin_flight(ms(0));
    for (int t = 1; t <= 101; ++t) {
      estimator.update(at(ms(t), {}, axial_m_s2));
    }
    EXPECT_EQ(estimator.motion(ms(101)).thrust_since, less ? ms(0) : ms(101));
  }
}

TEST(MotionEstimator, AMicrosecondLessThanATenthOfASecondInTheGuideIsNoStanding) {
  MotionEstimator estimator{default_plan().motion};
  estimator.begin_flight(ms(0));
  for (int t = 1; t <= 100; ++t) {
    estimator.update(at(ms(t), {}, g));
  }
  for (const int t_us : {100'999, 101'000}) {
    estimator.update(at(Microseconds{t_us}, {}, g));
    EXPECT_EQ(estimator.motion(Microseconds{t_us}).thrust_since, t_us == 101'000 ? Microseconds{t_us} : ms(0));
  }
}

TEST(MotionEstimator, APushInTheGuideEndsAStandAndTheTenthOfASecondBeginsAnew) {
  MotionEstimator estimator{default_plan().motion};
  estimator.begin_flight(ms(0));
  for (int t = 1; t <= 180; ++t) {  // 60 ms at 1 g, 20 ms at 3 g, 100 ms at 1 g, of which the low-pass takes some 20
    estimator.update(at(ms(t), {}, t > 60 && t <= 80 ? 3.0F * g : g));
    ASSERT_EQ(estimator.motion(ms(t)).thrust_since, ms(0)) << t;
  }
}

TEST(MotionEstimator, OnThePadAGapOfExactlyTheStaleTimeKeepsTheWindowAndALongerOneEndsIt) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(5);
  for (const bool longer : {false, true}) {
    MotionEstimator estimator{plan};
    for (int t = 0; t <= 10; ++t) {
      estimator.update(at(ms(t), {}, t == 0 ? g : 3.0F * g));
    }
    const Microseconds next = ms(15) + Microseconds{longer ? 1 : 0};
    estimator.update(at(next, {}, 3.0F * g));
    EXPECT_EQ(estimator.motion(next).thrust_since, longer ? next : ms(1));
  }
}

TEST(MotionEstimator, WhatWasBridgedOnThePadIsForgottenAtLaunchDetectionAndAtTheStartInTheTunnel) {
  for (const bool tunnel : {false, true}) {
    MotionEstimator estimator{default_plan().motion};
    estimator.update(at(ms(0), {}, g));
    estimator.update(at(ms(100), {}, g));
    EXPECT_TRUE(estimator.motion(ms(100)).roll_is_bridged);
    tunnel ? estimator.begin_tunnel_run(ms(100)) : estimator.begin_flight(ms(100));
    EXPECT_FALSE(estimator.motion(ms(100)).roll_is_bridged);
  }
}

TEST(MotionEstimator, AFastTurnAcrossTheAxisTiltsTheRocketAsFarAsItsRateSays) {
  for (const auto axis : {&Vector3::y, &Vector3::z}) {
    MotionEstimator estimator{default_plan().motion};
    estimator.begin_flight(ms(0));
    estimator.leave_guide();
    Vector3 rate;
    rate.*axis = 50.0F;
    for (int t = 0; t <= 40; t += 4) {  // 0.2 rad a step
      estimator.update(at(ms(t), rate, g));
    }
    EXPECT_NEAR(estimator.motion(ms(40)).tilt.radians(), 2.0F, 2e-5F);
  }
}

TEST(MotionEstimator, TheBiasAcrossTheAxisTiltsNothing) {
  for (const std::array bias : {std::array{0.0, 0.017, 0.0}, std::array{0.0, 0.0, 0.017}}) {
    Flight flight{{.gyro_bias_rad_s = bias}};
    flight.stand();
    flight.estimator.begin_flight(flight.rig.time());
    flight.estimator.leave_guide();
    flight.run(ms(1'000), 0.0, 0.0);
    EXPECT_NEAR(flight.motion().tilt.radians(), 0.0F, 1e-5F);
  }
}

TEST(MotionEstimator, AGapOfExactlyTheStaleTimeIsNoBridge) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(5);
  for (const bool longer : {false, true}) {
    MotionEstimator estimator{plan};
    estimator.update(at(ms(0), {1.0F, 0.0F, 0.0F}, g));
    const Microseconds next = ms(5) + Microseconds{longer ? 1 : 0};
    estimator.update(at(next, {1.0F, 0.0F, 0.0F}, g));
    EXPECT_EQ(estimator.motion(next).roll_is_bridged, longer);
  }
}

TEST(MotionEstimator, EachMicrosecondBetweenTwoSamplesTurnsTheRocket) {
  MotionEstimator estimator{default_plan().motion};
  estimator.update(at(ms(0), {64.0F, 0.0F, 0.0F}, g));
  estimator.update(at(Microseconds{1}, {64.0F, 0.0F, 0.0F}, g));
  EXPECT_FLOAT_EQ(estimator.motion(Microseconds{1}).roll_angle.radians(), 64e-6F);
}

TEST(MotionEstimator, TheTiltOfTheGuideIsKnownInTheTickAfterTheFirstAverageOfThePad) {
  MotionEstimator estimator{default_plan().motion};
  Inputs inputs;
  for (int t = 0; t <= 3'501; ++t) {
    inputs = at(ms(t), {}, g);
    inputs.accelerometers[0].specific_force_m_s2 = {0.96F * g, 0.0F, 0.28F * g};
    estimator.update(inputs);
    ASSERT_NEAR(estimator.motion(ms(t)).tilt.radians(), t <= 3'500 ? 0.0F : std::asin(0.28F), 1e-6F) << t;
  }
}

TEST(MotionAccelerometers, ASilentOneIsLostUntilItIsOlderThanTheStaleTimeAndThenHasFailed) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(5);
  MotionEstimator estimator{plan};
  estimator.update(at(ms(0), {}, g));
  for (const Microseconds now : {ms(5), ms(5) + Microseconds{1}}) {
    Inputs inputs = at(now, {}, g);
    inputs.accelerometers = {};
    estimator.update(inputs);
    EXPECT_EQ(estimator.motion(now).accelerometer, now == ms(5) ? SensorState::lost : SensorState::failed);
  }
}

TEST(MotionAccelerometers, WhileTheFirstRepeatsItsSampleTheSecondIsNotTaken) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 100; ++t) {
    Inputs inputs = at(ms(t), {}, 3.0F * g);
    inputs.accelerometers[0].time = ms(t - t % 2);
    inputs.accelerometers[1].specific_force_m_s2.x = 5.0F * g;
    estimator.update(inputs);
    const Motion motion = estimator.motion(ms(t));
    EXPECT_EQ(motion.accelerometer, t % 2 == 0 ? SensorState::fresh : SensorState::coasting);
    EXPECT_EQ(motion.specific_force_m_s2.x, 3.0F * g);
  }
  EXPECT_NEAR(estimator.motion(ms(100)).speed_m_s, 2.0F * g * 0.1F, 1e-4F);
}

TEST(MotionAccelerometers, WhileTheFirstIsBehindWhatWasIntegratedTheSecondGoesOn) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 20; ++t) {
    Inputs inputs = at(ms(t), {}, 3.0F * g);
    inputs.accelerometers[0].quality = t < 10 ? SampleQuality::absent : SampleQuality::valid;
    inputs.accelerometers[0].time = ms(t - 2);
    estimator.update(inputs);
    EXPECT_EQ(estimator.motion(ms(t)).accelerometer, SensorState::fresh) << t;
  }
}

TEST(MotionAccelerometers, OneAtTheEndOfItsRangeIsFreshAndWhenItRepeatsItselfTheSpeedStaysALowerBound) {
  MotionEstimator estimator{default_plan().motion};
  estimator.update(at(ms(0), {}, 3.0F * g));
  for (int t = 1; t <= 4; ++t) {
    Inputs inputs = at(ms(t), {}, 16.0F * g);
    for (AccelerometerSample& sample : inputs.accelerometers) {
      sample.quality = SampleQuality::saturated;
      sample.time = ms(t - 1 + t % 2);
    }
    estimator.update(inputs);
    EXPECT_EQ(estimator.motion(ms(t)).accelerometer, t % 2 == 1 ? SensorState::fresh : SensorState::coasting) << t;
    EXPECT_TRUE(estimator.motion(ms(t)).speed_is_lower_bound) << t;
  }
}

TEST(MotionAccelerometers, ASampleAtTheEndOfItsRangeThatWasSeenBeforeWithoutThatIsNoLowerBound) {
  MotionEstimator estimator{default_plan().motion};
  Inputs inputs = at(ms(1), {}, 3.0F * g);
  estimator.update(inputs);
  inputs.time = ms(2);
  for (AccelerometerSample& sample : inputs.accelerometers) {
    sample.quality = SampleQuality::saturated;
  }
  estimator.update(inputs);
  EXPECT_FALSE(estimator.motion(ms(2)).speed_is_lower_bound);
}

}  // namespace
}  // namespace fantail::core
