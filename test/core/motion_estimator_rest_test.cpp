// SPDX-License-Identifier: MIT

#include "milliseconds.hpp"
#include "motion_flight.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

void feed(MotionEstimator& estimator, Microseconds time, float axial_m_s2) {
  Inputs inputs;
  inputs.time = time;
  inputs.gyro = {time, {}, SampleQuality::valid};
  inputs.accelerometers.fill({time, {axial_m_s2, 0.0F, 0.0F}, SampleQuality::valid});
  estimator.update(inputs);
}

TEST(MotionEstimator, LongLiftByHandGathersAtMostOneSecondOfSpeedAndHeight) {
  Flight flight;
  flight.stand();
  float most_m_s = 0.0F;
  float most_m = 0.0F;
  for (int i = 0; i < 5'000; ++i) {
    flight.run(one_ms, 4.0, 0.0);
    most_m_s = std::max(most_m_s, flight.motion().speed_m_s);
    most_m = std::max(most_m, flight.motion().height_m);
  }
  EXPECT_NEAR(most_m_s, 4.0F, 0.01F);  // a t and a t^2 / 2 after 1 s
  EXPECT_NEAR(most_m, 2.0F, 0.01F);
}

TEST(MotionEstimator, AxialForceOfExactly1200MilliGIsThrust) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 100; ++t) {
    feed(estimator, ms(t), 1.2F * standard_gravity_m_s2);
  }
  EXPECT_NEAR(estimator.motion(ms(100)).speed_m_s, 0.2F * standard_gravity_m_s2 * 0.1F, 0.003F);
}

TEST(MotionEstimator, StandingInTheGuideIsBelievedAfterATenthOfASecond) {
  MotionEstimator estimator{default_plan().motion};
  feed(estimator, ms(0), standard_gravity_m_s2);
  estimator.begin_flight(ms(0));
  for (int t = 1; t <= 100; ++t) {
    feed(estimator, ms(t), standard_gravity_m_s2);
    ASSERT_EQ(estimator.motion(ms(t)).thrust_since, ms(0)) << t;
  }
  feed(estimator, ms(101), standard_gravity_m_s2);
  EXPECT_EQ(estimator.motion(ms(101)).thrust_since, ms(101));
}

TEST(MotionEstimator, FreeFallInsideTheGuideIsNoStanding) {
  Flight flight;
  flight.stand();
  flight.lift_off(60.0, 0.0);
  flight.run(ms(150), 60.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(400), -9.80665, 0.0);
  EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 1e-2);
}

TEST(MotionEstimator, StandingInAFailedLaunchDoesNotCountInTheNextOne) {
  MotionEstimator estimator{default_plan().motion};
  feed(estimator, ms(0), standard_gravity_m_s2);
  estimator.begin_flight(ms(0));
  for (int t = 1; t <= 50; ++t) {
    feed(estimator, ms(t), standard_gravity_m_s2);
  }
  estimator.return_to_pad();
  for (int t = 51; t <= 500; ++t) {
    feed(estimator, ms(t), standard_gravity_m_s2);
  }
  estimator.begin_flight(ms(500));
  for (int t = 501; t <= 600; ++t) {
    feed(estimator, ms(t), standard_gravity_m_s2);
    ASSERT_EQ(estimator.motion(ms(t)).thrust_since, ms(500)) << t;
  }
}

TEST(MotionEstimator, AccelerometersThatFallSilentOnThePadEndTheRest) {
  Flight flight;
  flight.stand();
  EXPECT_GT(flight.motion().at_rest_for, ms(3'900));
  for (int i = 0; i < 10; ++i) {
    flight.rig.advance(one_ms, 0.0, 0.0);
    Inputs inputs = flight.rig.inputs();
    inputs.accelerometers = {};
    flight.estimator.update(inputs);
  }
  EXPECT_EQ(flight.motion().accelerometer, SensorState::failed);
  EXPECT_EQ(flight.motion().at_rest_for, ms(0));
}

TEST(MotionEstimator, SampleFromTheFutureIsLost) {
  Flight flight;
  flight.stand();
  flight.rig.advance(one_ms, 0.0, 0.0);
  Inputs inputs = flight.rig.inputs();
  inputs.gyro.time += Microseconds{1};
  for (AccelerometerSample& sample : inputs.accelerometers) {
    sample.time += Microseconds{1};
  }
  flight.estimator.update(inputs);
  EXPECT_EQ(flight.motion().gyro, SensorState::lost);
  EXPECT_EQ(flight.motion().accelerometer, SensorState::lost);
}

}  // namespace
}  // namespace fantail::core
