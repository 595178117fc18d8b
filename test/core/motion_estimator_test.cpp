// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "motion_flight.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;
constexpr double degree = MotionRig::degree;

TEST(MotionEstimator, TiltedGuideAndRollCostNothing) {
  for (const double tilt_deg : {0.0, 5.0, 10.0, 15.0}) {
    for (const double azimuth_deg : {0.0, 77.0, 200.0}) {
      for (const double roll_deg_s : {0.0, 400.0, -700.0}) {
        Flight flight{{.tilt_deg = tilt_deg, .azimuth_deg = azimuth_deg, .first_roll_deg = 33.0}};
        flight.stand();
        flight.lift_off(50.0, roll_deg_s * degree);
        flight.run(ms(99), 50.0, roll_deg_s * degree);
        flight.estimator.begin_flight(flight.rig.time());
        flight.run(ms(400), 50.0, roll_deg_s * degree);
        const auto what = ::testing::Message() << tilt_deg << " " << azimuth_deg << " " << roll_deg_s;
        EXPECT_NEAR(flight.motion().distance_along_guide_m, flight.rig.distance_m(), 2e-3) << what;
        EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 2e-3) << what;
        EXPECT_NEAR(std::sqrt(flight.motion().speed_squared_m2_s2), flight.rig.speed_m_s(), 2e-3) << what;
        EXPECT_NEAR(flight.motion().height_m, flight.rig.height_m(), 2e-3) << what;
        EXPECT_NEAR(flight.motion().vertical_speed_m_s, flight.rig.speed_m_s() * std::cos(tilt_deg * degree), 2e-3)
            << what;
        EXPECT_NEAR(flight.motion().tilt.degrees(), tilt_deg, 0.05) << what;
      }
    }
  }
}

TEST(MotionEstimator, HeightOfAWholeFlightIsKeptToDecimetres) {
  Flight flight{{.tilt_deg = 5.0, .azimuth_deg = 120.0}};
  flight.stand();
  flight.lift_off(38.0, 200.0 * degree);
  flight.run(ms(99), 38.0, 200.0 * degree);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(400), 38.0, 200.0 * degree);
  flight.estimator.leave_guide();
  flight.run(ms(2'000), 35.0, -150.0 * degree);
  flight.run(ms(9'500), -10.7, 300.0 * degree);
  EXPECT_NEAR(flight.motion().height_m, flight.rig.height_m(), 0.1);
  EXPECT_NEAR(flight.motion().vertical_speed_m_s, flight.rig.speed_m_s() * std::cos(5.0 * degree), 0.01);
}

TEST(MotionEstimator, HeightOriginsAreClosedForms) {
  constexpr double a = 40.0;
  for (const HeightOrigin origin : {HeightOrigin::replay, HeightOrigin::velocity_only, HeightOrigin::from_detection}) {
    Flight flight{{}, origin};
    flight.stand();
    flight.lift_off(a, 0.0);
    flight.run(ms(200), a, 0.0);
    flight.estimator.begin_flight(flight.rig.time());
    flight.run(ms(300), a, 0.0);
    const double held_s = 0.2005;
    const double since_s = 0.3;
    const double v0 = origin == HeightOrigin::from_detection ? 0.0 : a * held_s;
    const double h0 = origin == HeightOrigin::replay ? 0.5 * a * held_s * held_s : 0.0;
    EXPECT_NEAR(flight.motion().height_m, h0 + v0 * since_s + 0.5 * a * since_s * since_s, 1e-3);
    EXPECT_NEAR(flight.motion().speed_m_s, v0 + a * since_s, 1e-3);
  }
}

// The definition of the replayed window, in double: every raw sample from the last one whose low-passed axial specific
// force was below 1.2 g.
TEST(MotionEstimator, ReplayedWindowBeginsWithTheLastLowPassedSampleBelow1200MilliG) {
  std::vector<double> axial(4'000, static_cast<double>(g));
  for (int i = 0; i < 250; ++i) {  // a ragged ignition
    const double ramp = 9.8 + 0.15 * i + (i % 5 == 0 ? 6.0 : -1.5) + (i > 20 && i < 40 ? -6.0 : 0.0);
    axial.push_back(ramp);
  }
  MotionEstimator estimator{plan_with(HeightOrigin::replay)};
  const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * 16.0 * 1e-3);
  double filtered = axial[0];
  std::size_t start = 0;
  for (std::size_t i = 0; i < axial.size(); ++i) {
    filtered += share * (axial[i] - filtered);
    start = filtered < 1.2 * static_cast<double>(g) ? i : start;
    Inputs inputs;
    inputs.time = ms(static_cast<int>(i));
    inputs.gyro = {inputs.time, {}, SampleQuality::valid};
    inputs.accelerometers[0] = {inputs.time, {static_cast<float>(axial[i]), 0.0F, 0.0F}, SampleQuality::valid};
    estimator.update(inputs);
  }
  double speed = 0.0;
  double height = 0.0;
  for (std::size_t i = start + 1; i < axial.size(); ++i) {
    const double before = speed;
    speed += (0.5 * (axial[i] + axial[i - 1]) - static_cast<double>(g)) * 1e-3;
    height += 0.5 * (speed + before) * 1e-3;
  }
  const Microseconds now = ms(static_cast<int>(axial.size()) - 1);
  estimator.begin_flight(now);
  EXPECT_EQ(estimator.motion(now).thrust_since, ms(static_cast<int>(start)));
  EXPECT_NEAR(estimator.motion(now).speed_m_s, speed, 1e-4);
  EXPECT_NEAR(estimator.motion(now).height_m, height, 1e-4);
}

TEST(MotionEstimator, SlowIgnitionBeforeALongHoldIsReplayedWhole) {
  Flight flight;
  flight.stand();
  flight.lift_off(4.0, 0.0);
  flight.run(ms(300), 4.0, 0.0);
  flight.run(ms(500), 20.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 0.03);  // until 1.2 g shows: ln 2 of 10 ms at 4 m/s2
  EXPECT_NEAR(flight.motion().height_m, flight.rig.height_m(), 0.03);
}

TEST(MotionEstimator, CarryingTheRocketAboutGathersNoHeight) {
  Flight flight;
  flight.stand();
  for (int i = 0; i < 20; ++i) {
    flight.run(ms(300), 4.0, 0.0);
    flight.run(ms(300), -4.0, 0.0);
  }
  flight.stand(ms(100));
  EXPECT_EQ(flight.motion().height_m, 0.0F);
  EXPECT_EQ(flight.motion().speed_m_s, 0.0F);
}

TEST(MotionEstimator, GapInTheSamplesOnThePadGathersNoHeight) {
  Flight flight;
  flight.stand();
  flight.lift_off(40.0, 0.0);
  flight.rig.advance(ms(500), 40.0, 0.0);
  flight.estimator.update(flight.rig.inputs());
  EXPECT_EQ(flight.motion().speed_m_s, 0.0F);
}

TEST(MotionEstimator, RocketThatStandsInItsGuideAgainHasNoSpeed) {
  Flight flight;
  flight.stand();
  flight.lift_off(147.0, 0.0);
  flight.run(ms(79), 147.0, 0.0);
  flight.run(ms(20), 0.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  EXPECT_GT(flight.motion().speed_m_s, 11.0F);
  flight.run(ms(250), 0.0, 0.0);
  EXPECT_EQ(flight.motion().speed_m_s, 0.0F);
  EXPECT_EQ(flight.motion().distance_along_guide_m, 0.0F);
}

TEST(MotionEstimator, DipInTheThrustKeepsTheSpeed) {
  Flight flight;
  flight.stand();
  flight.lift_off(40.0, 0.0);
  flight.run(ms(100), 40.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(60), 0.0, 0.0);  // for a moment the thrust is just the weight
  flight.run(ms(100), 40.0, 0.0);
  EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 1e-2);
}

TEST(MotionEstimator, BeyondTheGuideThrustEqualToTheWeightKeepsTheSpeed) {
  Flight flight;
  flight.stand();
  flight.lift_off(40.0, 0.0);
  flight.run(ms(500), 40.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  flight.estimator.leave_guide();
  flight.run(ms(1'000), 0.0, 0.0);
  EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 1e-2);
}

TEST(MotionEstimator, ReturnToThePadStartsOverAtRest) {
  Flight flight;
  flight.stand();
  flight.lift_off(40.0, 0.0);
  flight.run(ms(100), 40.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(30), -30.0, 0.0);
  flight.estimator.return_to_pad();
  flight.run(ms(100), 0.0, 0.0);
  EXPECT_EQ(flight.motion().speed_m_s, 0.0F);
  EXPECT_EQ(flight.motion().height_m, 0.0F);
}

void saturate_at_16_g(AccelerometerSample& sample) {
  sample.specific_force_m_s2.x = 16.0F * g;
  sample.quality = SampleQuality::saturated;
}

// 19 g upwards for 0.2 s, with one or both of the accelerometers at the end of their range.
Motion pushed_beyond_the_range(std::size_t saturated, const std::function<void(Inputs&)>& change = [](Inputs&) {}) {
  Flight flight;
  flight.stand();
  for (int i = 0; i < 200; ++i) {
    flight.rig.advance(one_ms, 19.0 * static_cast<double>(g), 0.0);
    Inputs inputs = flight.rig.inputs();
    for (std::size_t k = 0; k < saturated; ++k) {
      saturate_at_16_g(inputs.accelerometers[k]);
    }
    change(inputs);
    flight.estimator.update(inputs);
  }
  return flight.motion();
}

TEST(MotionEstimator, AnAccelerometerThatMeasuresGoesBeforeOneAtTheEndOfItsRange) {
  const Motion motion = pushed_beyond_the_range(1);
  EXPECT_NEAR(motion.speed_m_s, 19.0F * g * 0.2F, 19.0F * g * 0.001F);
  EXPECT_FALSE(motion.speed_is_lower_bound);
}

TEST(MotionEstimator, ASlowerAccelerometerThatMeasuresIsWaitedForRatherThanASaturatedOneTaken) {
  const Motion motion = pushed_beyond_the_range(1, [](Inputs& inputs) { inputs.accelerometers[1].time -= 2 * one_ms; });
  EXPECT_NEAR(motion.speed_m_s, 19.0F * g * 0.198F, 19.0F * g * 0.001F);
  EXPECT_FALSE(motion.speed_is_lower_bound);
}

TEST(MotionEstimator, WithAllAtTheEndOfTheirRangeHeightAndSpeedAreLowerBoundsUntilTheRocketStandsAgain) {
  const Motion motion = pushed_beyond_the_range(2);
  EXPECT_NEAR(motion.speed_m_s, 15.0F * g * 0.2F, 15.0F * g * 0.001F);
  EXPECT_TRUE(motion.speed_is_lower_bound);

  Flight flight;
  flight.stand();
  flight.rig.advance(one_ms, 19.0 * static_cast<double>(g), 0.0);
  Inputs inputs = flight.rig.inputs();
  std::ranges::for_each(inputs.accelerometers, saturate_at_16_g);
  flight.estimator.update(inputs);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(50), 40.0, 0.0);
  EXPECT_TRUE(flight.motion().speed_is_lower_bound) << "one such sample is enough";
  flight.estimator.return_to_pad();
  flight.run(ms(100), 0.0, 0.0);
  EXPECT_FALSE(flight.motion().speed_is_lower_bound);
}

TEST(MotionEstimator, SecondAccelerometerStandsInForTheFirst) {
  Flight flight;
  flight.stand();
  flight.lift_off(40.0, 0.0);
  for (int i = 0; i < 300; ++i) {
    flight.rig.advance(one_ms, 40.0, 0.0);
    Inputs inputs = flight.rig.inputs();
    inputs.accelerometers[0].quality = i % 3 == 0 ? SampleQuality::valid : SampleQuality::invalid;
    flight.estimator.update(inputs);
    EXPECT_EQ(flight.motion().accelerometer, SensorState::fresh);
  }
  EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 1e-3);
}

TEST(MotionEstimator, BadAccelerometerSamplesNeverEnterTheState) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 3e38F, -3e38F}) {
    for (const std::size_t axis : {0U, 1U, 2U}) {
      Flight flight;
      flight.stand();
      flight.lift_off(40.0, 1.0);
      for (int i = 0; i < 100; ++i) {
        flight.rig.advance(one_ms, 40.0, 1.0);
        Inputs inputs = flight.rig.inputs();
        if (i % 10 == 5) {
          for (AccelerometerSample& sample : inputs.accelerometers) {
            Vector3& force = sample.specific_force_m_s2;
            (axis == 0 ? force.x : axis == 1 ? force.y : force.z) = bad;
          }
        }
        flight.estimator.update(inputs);
      }
      EXPECT_NEAR(flight.motion().speed_m_s, flight.rig.speed_m_s(), 1e-2);
      flight.estimator.return_to_pad();
      flight.run(ms(5'000), 0.0, 0.0);
      EXPECT_GT(flight.motion().at_rest_for, ms(4'500));  // the filter of the pad window is sound too
    }
  }
}

TEST(MotionEstimator, EmptyInputsAreAFailureNotAnAnswer) {
  MotionEstimator estimator{default_plan().motion};
  estimator.update(Inputs{});
  EXPECT_EQ(estimator.motion({}).gyro, SensorState::failed);
  EXPECT_EQ(estimator.motion({}).accelerometer, SensorState::failed);
}

}  // namespace
}  // namespace fantail::core
