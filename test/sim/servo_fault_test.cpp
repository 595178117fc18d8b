// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "servo_test_rig.hpp"

namespace fantail::sim {
namespace {

// Half a second at 5 deg, then the fault.
ServoRig broken_at_five_degrees(ServoFault fault, ServoParameters parameters = ideal()) {
  ServoRig rig{parameters};
  rig.run(1.0, pulse_us(5.0));
  rig.servo.fail(fault);
  return rig;
}

TEST(ServoFault, AStuckServoStaysWhereItIs) {
  ServoRig rig = broken_at_five_degrees(ServoFault::stuck);
  rig.run(1.5, pulse_us(-8.0));
  rig.run(1.6, std::nullopt);
  EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12);
  EXPECT_NEAR(rig.servo.mean_angle_rad() / degree, 5.0, 1e-12);
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

TEST(ServoFault, ARepairedServoGoesOnFromWhereItsShaftStands) {
  for (const ServoFault fault :
       {ServoFault::stuck, ServoFault::hardover, ServoFault::dead, ServoFault::slipping, ServoFault::reversed}) {
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
