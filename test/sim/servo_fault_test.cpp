// SPDX-License-Identifier: MIT

#include "servo_test_rig.hpp"
#include "sim/random.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr std::array every_fault{ServoFault::stuck,     ServoFault::hardover, ServoFault::dead,
                                 ServoFault::slipping,  ServoFault::reversed, ServoFault::slow,
                                 ServoFault::wrong_trim};

// A second at 5 deg, then the fault.
ServoRig broken_at_five_degrees(ServoFault fault, ServoParameters parameters = ideal(),
                                std::optional<double> angle_rad = std::nullopt) {
  ServoRig rig{parameters};
  rig.run(1.0, pulse_us(5.0));
  rig.servo.fail(fault, angle_rad);
  return rig;
}

TEST(ServoFault, AStuckServoStaysWhereItIs) {
  ServoRig rig = broken_at_five_degrees(ServoFault::stuck);
  rig.run(1.5, pulse_us(-8.0));
  rig.run(1.6, std::nullopt);
  EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12);
  EXPECT_NEAR(rig.servo.mean_angle_rad() / degree, 5.0, 1e-12);
}

TEST(ServoFault, AStuckServoMayBeJammedAtAGivenAngleFromTheBeginning) {
  ServoRig rig = broken_at_five_degrees(ServoFault::stuck, ideal(), -3.0 * degree);
  EXPECT_NEAR(rig.angle_deg(), -3.0, 1e-12);
  rig.run(1.5, pulse_us(-8.0));
  EXPECT_NEAR(rig.angle_deg(), -3.0, 1e-12);
  EXPECT_NEAR(rig.servo.mean_angle_rad() / degree, -3.0, 1e-12);
  rig.servo.fail(ServoFault::stuck);  // without an angle: where it stands
  EXPECT_NEAR(rig.angle_deg(), -3.0, 1e-12);

  ServoRig never_powered{ideal()};
  never_powered.servo.fail(ServoFault::stuck, 3.0 * degree);
  never_powered.run(0.1, std::nullopt);
  EXPECT_NEAR(never_powered.angle_deg(), 3.0, 1e-12);
}

TEST(ServoFault, AHardoverRunsToThePositiveStopAtTheRateLimit) {
  ServoParameters p = ideal();
  p.stop_rad = 25.0 * degree;
  p.rate_limit_rad_s = 100.0 * degree;
  for (const std::optional<double> pulse : {std::optional{pulse_us(-20.0)}, std::optional<double>{}}) {
    ServoRig rig = broken_at_five_degrees(ServoFault::hardover, p);
    const double start_deg = rig.angle_deg();
    rig.run(1.1, pulse);
    EXPECT_NEAR(rig.angle_deg(), start_deg + 10.0, 1e-9);
    rig.run(1.5, pulse);
    EXPECT_NEAR(rig.angle_deg(), 25.0, 1e-12);
  }
}

TEST(ServoFault, ADeadServoIsTurnedBackToZeroByTheAir) {
  ServoRig rig = broken_at_five_degrees(ServoFault::dead);
  rig.run(1.03, pulse_us(-8.0));
  EXPECT_NEAR(rig.angle_deg(), 5.0 * std::exp(-0.03 / 0.020), 1e-9);
  rig.run(2.0, pulse_us(-8.0));
  EXPECT_NEAR(rig.angle_deg(), 0.0, 1e-12);
}

TEST(ServoFault, ASlippingShaftLosesAThirdOfEveryMovement) {
  ServoRig rig = broken_at_five_degrees(ServoFault::slipping);
  EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12);  // no jump
  rig.run(2.0, pulse_us(8.0));
  EXPECT_NEAR(rig.angle_deg(), 5.0 + 2.0, 1e-12);
  rig.run(3.0, pulse_us(-10.0));
  EXPECT_NEAR(rig.angle_deg(), 5.0 - 10.0, 1e-12);
}

TEST(ServoFault, AReversedServoMovesTheOtherWay) {
  ServoRig rig = broken_at_five_degrees(ServoFault::reversed);
  rig.run(1.02, pulse_us(5.0));
  EXPECT_NEAR(rig.angle_deg(), -5.0 + 10.0 * std::exp(-1.0), 1e-9);
  rig.run(2.0, pulse_us(8.0));
  EXPECT_NEAR(rig.angle_deg(), -8.0, 1e-12);
}

TEST(ServoFault, ASlowServoHasFourTimesTheLag) {
  ServoRig rig = broken_at_five_degrees(ServoFault::slow);
  EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12);
  while (rig.time_s() < 1.5) {
    const double before_s = rig.time_s() - 1.0;
    rig.servo.step(rig.time_s(), rig.dt_s, pulse_us(-7.0));
    ++rig.tick;
    const double now_s = rig.time_s() - 1.0;
    EXPECT_NEAR(rig.angle_deg(), -7.0 + 12.0 * std::exp(-now_s / 0.080), 1e-9);
    const double mean = -7.0 + 12.0 * 0.080 / rig.dt_s * (std::exp(-before_s / 0.080) - std::exp(-now_s / 0.080));
    EXPECT_NEAR(rig.servo.mean_angle_rad() / degree, mean, 1e-8);
  }
}

TEST(ServoFault, ASlowServoHasAQuarterOfTheRateLimit) {
  ServoParameters p = ideal();
  p.rate_limit_rad_s = 100.0 * degree;
  ServoRig rig = broken_at_five_degrees(ServoFault::slow, p);
  const double start_deg = rig.angle_deg();
  // 25 deg/s; from 2 deg (rate times lag) before the goal on, the exponential is slower.
  const double limited_s = (start_deg + 20.0 - 2.0) / 25.0;
  while (rig.time_s() < 2.5) {
    rig.servo.step(rig.time_s(), rig.dt_s, pulse_us(-20.0));
    ++rig.tick;
    const double t = rig.time_s() - 1.0;
    const double expected = t < limited_s ? start_deg - 25.0 * t : -20.0 + 2.0 * std::exp(-(t - limited_s) / 0.080);
    EXPECT_NEAR(rig.angle_deg(), expected, 1e-9) << t;
  }
}

TEST(ServoFault, AWrongTrimMovesTheShaftAtOnceAndStaysForEveryCommand) {
  for (const double off_deg : {2.5, -14.0}) {
    ServoRig rig = broken_at_five_degrees(ServoFault::wrong_trim, ideal(), off_deg * degree);
    EXPECT_NEAR(rig.angle_deg(), 5.0 + off_deg, 1e-12);
    rig.run(1.3, pulse_us(5.0));
    EXPECT_NEAR(rig.angle_deg(), 5.0 + off_deg, 1e-12) << "the servo believes it stands right";
    rig.run(1.32, pulse_us(-8.0));
    EXPECT_NEAR(rig.angle_deg(), -8.0 + off_deg + 13.0 * std::exp(-1.0), 1e-5);
    rig.run(2.3, std::nullopt);
    rig.run(3.3, pulse_us(0.0));
    EXPECT_NEAR(rig.angle_deg(), off_deg, 1e-12);
    rig.servo.fail(ServoFault::wrong_trim, 1.0 * degree);  // another angle takes the place of the first
    EXPECT_NEAR(rig.angle_deg(), 1.0, 1e-12);
  }
  EXPECT_NEAR(broken_at_five_degrees(ServoFault::wrong_trim).angle_deg(), 7.5, 1e-12);
}

TEST(ServoFault, AWrongTrimIsThereBeforeTheServoHasPower) {
  ServoRig rig{ideal()};
  rig.servo.fail(ServoFault::wrong_trim, 2.5 * degree);
  rig.run(0.1, std::nullopt);
  EXPECT_NEAR(rig.angle_deg(), 2.5, 1e-12);
}

TEST(ServoFault, AWrongTrimDoesNotReachBeyondTheStop) {
  ServoParameters p = ideal();
  p.stop_rad = 6.0 * degree;
  p.backlash_rad = 1.0 * degree;
  ServoRig rig = broken_at_five_degrees(ServoFault::wrong_trim, p, 2.5 * degree);
  EXPECT_NEAR(rig.angle_deg(), 6.0, 1e-12);
  rig.run(2.0, pulse_us(6.0));
  EXPECT_NEAR(rig.angle_deg(), 6.0, 1e-12);
  rig.run(3.0, pulse_us(-6.0));
  EXPECT_NEAR(rig.angle_deg(), -3.5 + 0.5, 1e-12);
  rig.run(4.0, pulse_us(-20.0));
  EXPECT_NEAR(rig.angle_deg(), -6.0, 1e-12);
  rig.servo.fail(ServoFault::stuck, 9.0 * degree);
  EXPECT_NEAR(rig.angle_deg(), 6.0, 1e-12);
}

TEST(ServoFault, RefusesAnAngleThatIsNotANumber) {
  Servo servo{ideal()};
  EXPECT_THROW(servo.fail(ServoFault::wrong_trim, std::nan("")), std::invalid_argument);
  EXPECT_THROW(servo.fail(ServoFault::stuck, HUGE_VAL), std::invalid_argument);
}

TEST(ServoFault, WhateverBreaksAndWhenTheShaftStaysInsideTheStopHoweverTimeIsCut) {
  constexpr std::uint64_t seed = 77;
  SCOPED_TRACE(seed);
  Random random{seed, 0};
  const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  for (int round = 0; round < 20; ++round) {
    const ServoParameters p{.lag_s = between(0.005, 0.03),
                            .delay_s = between(0.0, 0.01),
                            .frame_period_s = 0.002,
                            .rate_limit_rad_s = between(100.0, 900.0) * degree,
                            .stop_rad = 10.0 * degree,
                            .backlash_rad = between(0.0, 1.0) * degree,
                            .centre_rad = between(-2.0, 2.0) * degree};
    ServoRig coarse{p, 0.012};
    ServoRig fine{p, 0.0005};
    for (int step = 1; step <= 200; ++step) {
      if (random.uniform() < 0.1) {
        const auto which = static_cast<std::size_t>(between(0.0, every_fault.size() + 1.0));
        const ServoFault fault = which < every_fault.size() ? every_fault[which] : ServoFault::none;
        const auto angle_rad = random.uniform() < 0.5 ? std::optional{between(-15.0, 15.0) * degree} : std::nullopt;
        coarse.servo.fail(fault, angle_rad);
        fine.servo.fail(fault, angle_rad);
      }
      const auto pulse = random.uniform() < 0.9 ? std::optional{pulse_us(between(-20.0, 20.0))} : std::nullopt;
      coarse.run(0.012 * step, pulse);
      fine.run(0.012 * step, pulse);
      ASSERT_LE(std::abs(coarse.angle_deg()), 10.0 + 1e-12) << round << " at " << coarse.time_s();
      ASSERT_LE(std::abs(fine.angle_deg()), 10.0 + 1e-12) << round << " at " << fine.time_s();
      ASSERT_NEAR(coarse.angle_deg(), fine.angle_deg(), 1e-8) << round << " at " << coarse.time_s();
    }
  }
}

TEST(ServoFault, ARepairedServoGoesOnFromWhereItsShaftStands) {
  for (const ServoFault fault : every_fault) {
    ServoRig rig = broken_at_five_degrees(fault);
    rig.run(1.02, pulse_us(-7.0));
    const double stands_deg = rig.angle_deg();
    rig.servo.fail(ServoFault::none);
    EXPECT_NEAR(rig.angle_deg(), stands_deg, 1e-12);
    rig.run(1.04, pulse_us(-7.0));
    EXPECT_NEAR(rig.angle_deg(), -7.0 + (stands_deg + 7.0) * std::exp(-1.0), 1e-9) << static_cast<int>(fault);
  }
}

TEST(ServoFault, AFaultBeforeTheFirstPulseActsOnTheFirstCommand) {
  ServoRig rig{ideal()};
  rig.servo.fail(ServoFault::reversed);
  rig.run(1.0, pulse_us(5.0));
  EXPECT_NEAR(rig.angle_deg(), -5.0, 1e-12);
}

}  // namespace
}  // namespace fantail::sim
