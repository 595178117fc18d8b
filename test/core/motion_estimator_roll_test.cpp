// SPDX-License-Identifier: MIT

#include "core/finite.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/motion_estimator.hpp"
#include "milliseconds.hpp"
#include "motion_rig.hpp"
#include "random_stream.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr double degree = MotionRig::degree;

/// A rocket that only turns.
class Spin {
 public:
  explicit Spin(const MotionRig::Setup& setup = {}) : rig{setup} {}

  void run(Microseconds length, double roll_rate_rad_s) {
    for (const Microseconds end = rig.time() + length; rig.time() < end;) {
      rig.advance(one_ms, 0.0, roll_rate_rad_s);
      estimator.update(rig.inputs());
    }
  }
  /// One tick in which the gyro has `quality`.
  void tick(double roll_rate_rad_s, SampleQuality quality) {
    rig.advance(one_ms, 0.0, roll_rate_rad_s);
    Inputs inputs = rig.inputs();
    inputs.gyro.quality = quality;
    estimator.update(inputs);
  }
  [[nodiscard]] Motion motion() const { return estimator.motion(rig.time()); }

  MotionRig rig;
  MotionEstimator estimator{default_plan().motion};
};

TEST(RollAngle, IsUnwrappedAndKeptOverManyTurns) {
  Spin spin;
  spin.estimator.begin_flight(Microseconds{0});
  spin.run(one_ms, 0.0);
  // Ten minutes at 700 deg/s: 1167 turns. A plain float sum would be off by tens of degrees.
  spin.run(ms(600'000), 700.0 * degree);
  EXPECT_NEAR(spin.motion().roll_angle.radians(), spin.rig.roll_rad() - 0.0005 * 700.0 * degree, 2e-3);
}

TEST(RollAngle, IsTheTrapezoidOfTheRateAtAnySampling) {
  Spin spin;
  double t_s = 0.0;
  int step_us = 1'000;
  // A rate of 5 sin(20 t) rad/s, sampled every 0.6 to 1.4 ms: the integral is (1 - cos(20 t)) / 4.
  for (int i = 0; i < 4'000; ++i) {
    step_us = 600 + (step_us * 7'919 + 13) % 801;
    spin.rig.advance(Microseconds{step_us}, 0.0, 0.0);
    t_s = static_cast<double>(spin.rig.time().count()) * 1e-6;
    Inputs inputs = spin.rig.inputs();
    inputs.gyro.rate_rad_s.x = static_cast<float>(5.0 * std::sin(20.0 * t_s));
    spin.estimator.update(inputs);
  }
  EXPECT_NEAR(spin.motion().roll_angle.radians(), 0.25 * (1.0 - std::cos(20.0 * t_s)), 1e-3);
}

TEST(RollAngle, IsZeroAtLaunchDetectionEvenWithASampleThatIsALittleOld) {
  for (const bool tunnel : {false, true}) {
    Spin spin;
    spin.run(ms(1'000), 2.0);
    const Microseconds now = spin.rig.time() + Microseconds{700};
    tunnel ? spin.estimator.begin_tunnel_run(now) : spin.estimator.begin_flight(now);
    EXPECT_EQ(spin.estimator.motion(now).roll_angle, Angle{});
    const double before = spin.rig.roll_rad() + 2.0 * 0.0007;
    spin.run(ms(1'000), 2.0);
    EXPECT_NEAR(spin.motion().roll_angle.radians(), spin.rig.roll_rad() - before, 1e-5);
  }
}

TEST(RollAngle, PositiveRollTurnsYTowardsZ) {
  Spin spin;
  spin.run(ms(10), 1.0);
  EXPECT_GT(spin.motion().roll_angle, Angle{});
  EXPECT_GT(spin.motion().roll_rate_rad_s, 0.0F);
}

TEST(RollAngle, HoursOnThePadCostNothing) {
  Spin spin{{.gyro_bias_rad_s = {0.012, -0.01, 0.005}}};
  // Twelve hours have gone by before the first sample, and then come some minutes of waiting.
  spin.rig.advance(Microseconds{12LL * 3'600'000'000}, 0.0, 0.0);
  spin.run(ms(120'000), 0.0);
  spin.estimator.begin_flight(spin.rig.time());
  const double before = spin.rig.roll_rad();
  spin.run(ms(12'000), 3.0);
  // Half a tick of the step from rest to 3 rad/s is not seen by the trapezoid.
  EXPECT_NEAR(spin.motion().roll_angle.radians(), spin.rig.roll_rad() - before - 0.0005 * 3.0, 2e-5);
}

TEST(RollAngle, TheFastestAdmissibleRatesLeaveTheAttitudeARotation) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(20);  // the longest allowed: each step turns the rocket as far as any can
  MotionEstimator estimator{plan};
  estimator.begin_flight(ms(0));  // on the pad the attitude would begin anew with every sample
  estimator.leave_guide();
  RandomStream random{1};
  const auto fastest = [&] { return random.chance(0.5) ? largest_rate_rad_s : -largest_rate_rad_s; };
  Inputs inputs;
  for (int step = 0; step < 1000; ++step) {
    inputs.time += ms(20);
    inputs.gyro = {
        .time = inputs.time, .rate_rad_s = {fastest(), fastest(), fastest()}, .quality = SampleQuality::valid};
    inputs.accelerometers[0] = {.time = inputs.time,
                                .specific_force_m_s2 = {standard_gravity_m_s2, 0.0F, 0.0F},
                                .quality = SampleQuality::valid};
    estimator.update(inputs);
    const Motion motion = estimator.motion(inputs.time);
    ASSERT_TRUE(is_finite(motion.tilt.radians())) << step;
    ASSERT_LE(std::abs(motion.vertical_speed_m_s),
              0.021F * 2.0F * standard_gravity_m_s2 * static_cast<float>(step + 1));
  }
}

TEST(GyroBias, IsTheMeanOfTheStillWindowAndIsFrozenAtDetection) {
  Spin spin{{.gyro_bias_rad_s = {0.015, 0.0, 0.0}}};
  spin.run(ms(4'000), 0.0);
  EXPECT_NEAR(spin.motion().roll_rate_rad_s, 0.0F, 1e-6F);
  spin.run(ms(450), 0.01);  // what happens in the last half second does not count
  spin.estimator.begin_flight(spin.rig.time());
  EXPECT_NEAR(spin.motion().roll_rate_rad_s, 0.01F, 1e-6F);
  spin.run(ms(10'000), 0.01);  // still enough for a pad window, but the bias is frozen
  EXPECT_NEAR(spin.motion().roll_rate_rad_s, 0.01F, 1e-6F);
}

TEST(GyroBias, MotionVoidsTheWindowAndTheLastGoodBiasStays) {
  Spin spin{{.gyro_bias_rad_s = {0.015, 0.0, 0.0}}};
  spin.run(ms(4'000), 0.0);
  for (int i = 0; i < 10; ++i) {
    spin.run(ms(100), 0.5);
    spin.run(ms(900), 0.01);
  }
  EXPECT_NEAR(spin.motion().roll_rate_rad_s, 0.01F, 1e-6F);
}

TEST(GyroBias, IsLearntFromAGyroThatIsSlowerThanTheTickAndLosesSamples) {
  for (const bool slow : {false, true}) {
    Spin spin{{.gyro_bias_rad_s = {0.015, 0.0, 0.0}}};
    Inputs held;
    for (int i = 0; i < 5'000; ++i) {
      spin.rig.advance(one_ms, 0.0, 0.0);
      Inputs inputs = spin.rig.inputs();
      if (!slow && i % 50 == 0) {
        inputs.gyro = {};
      } else if (slow && i % 2 == 1) {
        inputs.gyro = held.gyro;
      }
      held = inputs;
      spin.estimator.update(inputs);
    }
    EXPECT_NEAR(spin.motion().roll_rate_rad_s, 0.0F, 1e-6F) << slow;
    EXPECT_GT(spin.motion().at_rest_for, ms(4'900)) << slow;
  }
}

TEST(LostGyro, LastRateIsIntegratedForFiveMillisecondsThenTheGyroHasFailed) {
  Spin spin;
  spin.run(ms(1'000), 2.0);
  const float before = spin.motion().roll_angle.radians();
  for (int i = 1; i <= 20; ++i) {
    spin.tick(2.0, SampleQuality::invalid);
    EXPECT_EQ(spin.motion().gyro, i <= 5 ? SensorState::lost : SensorState::failed) << i;
    EXPECT_NEAR(spin.motion().roll_angle.radians() - before, 0.002F * static_cast<float>(std::min(i, 5)), 1e-6F) << i;
  }
}

TEST(LostGyro, RepeatedSampleIsCoastedOnThenFailsToo) {
  Spin spin;
  spin.run(ms(1'000), 2.0);
  const GyroSample held = spin.rig.inputs().gyro;
  for (int i = 1; i <= 8; ++i) {
    spin.rig.advance(one_ms, 0.0, 2.0);
    Inputs inputs = spin.rig.inputs();
    inputs.gyro = held;
    spin.estimator.update(inputs);
    EXPECT_EQ(spin.motion().gyro, i <= 5 ? SensorState::coasting : SensorState::failed) << i;
  }
}

TEST(LostGyro, NotFiniteAndAbsurdRatesAreLostSamples) {
  for (const float bad : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN(), 3e38F, -2000.0F}) {
    for (const int axis : {0, 1, 2}) {
      Spin spin;
      spin.run(ms(10), 2.0);
      spin.rig.advance(one_ms, 0.0, 2.0);
      Inputs inputs = spin.rig.inputs();
      Vector3& rate = inputs.gyro.rate_rad_s;
      (axis == 0 ? rate.x : axis == 1 ? rate.y : rate.z) = bad;
      spin.estimator.update(inputs);
      EXPECT_EQ(spin.motion().gyro, SensorState::lost);
      spin.run(ms(10), 2.0);
      EXPECT_EQ(spin.motion().gyro, SensorState::fresh);
      EXPECT_NEAR(spin.motion().roll_angle.radians(), 0.040F, 1e-5F);
      EXPECT_LT(spin.motion().tilt.degrees(), 0.1F);
    }
  }
}

TEST(LostGyro, ClockThatRunsBackwardsDoesNotTurnTheRocket) {
  Spin spin;
  spin.run(ms(1'000), 2.0);
  const Angle before = spin.motion().roll_angle;
  EXPECT_EQ(spin.estimator.motion(ms(10)).roll_angle, before);
}

TEST(LostGyro, LossAndReturnNeverMakeTheAngleJump) {
  Spin spin;
  spin.run(ms(100), 2.0);
  float last = spin.motion().roll_angle.radians();
  for (int i = 0; i < 400; ++i) {
    const double rate = 2.0 + 0.01 * i;
    spin.tick(rate, i % 40 < i / 40 ? SampleQuality::absent : SampleQuality::valid);
    const float now = spin.motion().roll_angle.radians();
    // At most two ticks' worth: the tick itself and what the bridge with the older rate had missed.
    EXPECT_LE(std::abs(now - last), 2.0 * rate * 1e-3 + 1e-6) << i;
    last = now;
  }
}

}  // namespace
}  // namespace fantail::core
