// SPDX-License-Identifier: MIT

#include "servo_test_rig.hpp"
#include "sim/shaft_load.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double torque_n_m = 0.5;
constexpr double rate_deg_s = 200.0;

ServoParameters strong_for_its_torque() {
  ServoParameters p = ideal();
  p.lag_s = shortest_lag_s;
  p.rate_limit_rad_s = rate_deg_s * degree;
  p.torque_n_m = torque_n_m;
  return p;
}

/// The load is as strong as the servo at this angle.
ShaftLoad as_strong_at(double angle_deg) { return {.stiffness_n_m_per_rad = torque_n_m / (angle_deg * degree)}; }

TEST(ServoUnderLoad, IsSlowerAgainstTheLoadAndNotFasterWithIt) {
  for (const double load : {0.0, 0.25, 0.9}) {
    const ServoSpeeds speeds = speeds_under_load(10.0, load);
    EXPECT_DOUBLE_EQ(speeds.most_rad_s, 10.0) << load;
    EXPECT_DOUBLE_EQ(speeds.least_rad_s, -10.0 * (1.0 - load)) << load;
    const ServoSpeeds mirrored = speeds_under_load(10.0, -load);
    EXPECT_DOUBLE_EQ(mirrored.most_rad_s, 10.0 * (1.0 - load)) << load;
    EXPECT_DOUBLE_EQ(mirrored.least_rad_s, -10.0) << load;
  }
}

TEST(ServoUnderLoad, CannotHoldBeyondItsTorque) {
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, 1.0).least_rad_s, 0.0);
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, 1.5).least_rad_s, 5.0);
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, 1.5).most_rad_s, 10.0);
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, 4.0).least_rad_s, 30.0);
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, 4.0).most_rad_s, 30.0);
  EXPECT_DOUBLE_EQ(speeds_under_load(10.0, -1.5).most_rad_s, -5.0);
}

// dx/dt = r (1 - x / X): an exponential towards X, where the load is all that the servo has.
TEST(ServoUnderLoad, TurnsOutwardAsAnExponentialAndStopsWhereTheLoadIsItsTorque) {
  for (const double dt_s : {0.0002, 0.001, 0.004}) {
    ServoRig rig{strong_for_its_torque(), dt_s};
    rig.servo.set_load(as_strong_at(15.0));
    while (rig.time_s() < 1.0) {
      rig.run(rig.time_s() + dt_s, pulse_us(40.0));
      ASSERT_NEAR(rig.angle_deg(), 15.0 * (1.0 - std::exp(-rate_deg_s / 15.0 * rig.time_s())), 1e-9) << rig.time_s();
    }
    EXPECT_NEAR(rig.angle_deg(), 15.0, 1e-4);
  }
}

// Its speed is then zero, of whichever sign.
TEST(ServoUnderLoad, StaysWhereTheLoadIsExactlyItsTorque) {
  for (const double free_rad : {-1.0, 1.0}) {
    ServoRig rig{strong_for_its_torque()};
    rig.servo.set_load(ShaftLoad{.stiffness_n_m_per_rad = torque_n_m, .free_angle_rad = free_rad});
    for (const double against_deg : {10.0, 5.0}) {
      rig.run(rig.time_s() + 0.1, pulse_us(free_rad < 0.0 ? against_deg : -against_deg));
      EXPECT_EQ(rig.angle_deg(), 0.0) << free_rad;
    }
    rig.servo.set_load(ShaftLoad{});
    rig.run(rig.time_s() + 0.3, pulse_us(7.0));
    EXPECT_NEAR(rig.angle_deg(), 7.0, 1e-9) << "its gear still has an angle";
  }
}

TEST(ServoUnderLoad, ReachesAndHoldsWhatIsWithinItsTorqueOnlyLater) {
  ServoRig rig{strong_for_its_torque()};
  rig.servo.set_load(as_strong_at(15.0));
  // To 9 degrees without a load 45 ms; with it -15/200 s ln(1 - 9/15) = 69 ms.
  rig.run(0.060, pulse_us(9.0));
  EXPECT_NEAR(rig.angle_deg(), 15.0 * (1.0 - std::exp(-rate_deg_s / 15.0 * 0.060)), 1e-9);
  rig.run(0.080, pulse_us(9.0));
  EXPECT_NEAR(rig.angle_deg(), 9.0, 1e-3);
  rig.run(2.0, pulse_us(9.0));
  EXPECT_NEAR(rig.angle_deg(), 9.0, 1e-9);
}

TEST(ServoUnderLoad, ALoadThatHelpsDoesNotSpeedItUp) {
  ServoRig loaded{strong_for_its_torque()};
  ServoRig free{strong_for_its_torque()};
  loaded.run(0.5, pulse_us(12.0));
  free.run(0.5, pulse_us(12.0));
  loaded.servo.set_load(as_strong_at(15.0));
  for (int ms = 501; ms < 700; ++ms) {
    loaded.run(1e-3 * ms, pulse_us(0.0));
    free.run(1e-3 * ms, pulse_us(0.0));
    ASSERT_NEAR(loaded.angle_deg(), free.angle_deg(), 1e-9) << ms;
  }
}

// Held at 20 degrees when the air becomes too strong for more than 8.
TEST(ServoUnderLoad, IsPushedBackToWhereItCanHold) {
  for (const bool powered : {true, false}) {
    ServoRig rig{strong_for_its_torque()};
    rig.run(0.5, pulse_us(20.0));
    ASSERT_NEAR(rig.angle_deg(), 20.0, 1e-9);
    rig.servo.set_load(as_strong_at(8.0));
    const std::optional<double> pulse = powered ? std::optional{pulse_us(20.0)} : std::nullopt;
    for (int ms = 501; ms < 900; ++ms) {
      rig.run(1e-3 * ms, pulse);
      ASSERT_NEAR(rig.angle_deg(), 8.0 + 12.0 * std::exp(-rate_deg_s / 8.0 * 1e-3 * (ms - 500)), 1e-9) << ms;
    }
  }
}

// However strong the air: no overshoot, nothing infinite.
TEST(ServoUnderLoad, YieldsToAHurricaneWithoutOvershoot) {
  ServoRig rig{strong_for_its_torque()};
  rig.run(0.5, pulse_us(20.0));
  rig.servo.set_load(as_strong_at(1e-6));
  rig.run(0.501, pulse_us(20.0));
  EXPECT_NEAR(rig.angle_deg(), 1e-6, 1e-9);
  rig.servo.set_load({});
  rig.run(1.0, pulse_us(20.0));
  rig.servo.set_load(as_strong_at(-1e-6));
  rig.run(1.1, pulse_us(-20.0));
  EXPECT_NEAR(rig.angle_deg(), 60.0, 1e-9) << "to the stop";
}

// In front of the shaft the air turns the canard out: dx/dt = r (x / X - 1) once it is beyond X.
TEST(ServoUnderLoad, AnUnstableCanardRunsAwayBeyondItsTorqueOnly) {
  ServoRig within{strong_for_its_torque()};
  within.run(0.5, pulse_us(9.9));
  within.servo.set_load(as_strong_at(-10.0));
  within.run(1.0, pulse_us(9.9));
  EXPECT_NEAR(within.angle_deg(), 9.9, 1e-9);
  ServoRig beyond{strong_for_its_torque()};
  beyond.run(0.5, pulse_us(10.5));
  beyond.servo.set_load(as_strong_at(-10.0));
  beyond.run(0.6, pulse_us(0.0));
  EXPECT_NEAR(beyond.angle_deg(), 10.0 + 0.5 * std::exp(rate_deg_s / 10.0 * 0.1), 1e-6);
  beyond.run(2.0, pulse_us(0.0));
  EXPECT_NEAR(beyond.angle_deg(), 60.0, 1e-9);
}

TEST(ServoUnderLoad, WithoutATorqueNoLoadCounts) {
  ServoParameters p = strong_for_its_torque();
  p.torque_n_m.reset();
  ServoRig loaded{p};
  ServoRig free{p};
  loaded.servo.set_load(as_strong_at(3.0));
  for (int ms = 1; ms < 300; ++ms) {
    loaded.run(1e-3 * ms, pulse_us(ms < 150 ? 20.0 : -5.0));
    free.run(1e-3 * ms, pulse_us(ms < 150 ? 20.0 : -5.0));
    ASSERT_EQ(loaded.servo.angle_rad(), free.servo.angle_rad());
  }
}

TEST(ServoUnderLoad, AWeakLoadIsAlmostNone) {
  ServoParameters p{};
  p.torque_n_m = torque_n_m;
  ServoRig loaded{p};
  ServoRig free{p};
  loaded.servo.set_load(ShaftLoad{.stiffness_n_m_per_rad = 1e-9});
  for (int ms = 1; ms < 400; ++ms) {
    const double angle_deg = ms % 100 < 50 ? 18.0 : -7.0;
    loaded.run(1e-3 * ms, pulse_us(angle_deg));
    free.run(1e-3 * ms, pulse_us(angle_deg));
    ASSERT_NEAR(loaded.angle_deg(), free.angle_deg(), 1e-6);
    ASSERT_NEAR(loaded.servo.mean_angle_rad(), free.servo.mean_angle_rad(), 1e-8);
  }
}

TEST(ServoUnderLoad, AHardoverRunsAsFarAsTheLoadLetsItAndAJammedShaftStays) {
  ServoRig runaway{strong_for_its_torque()};
  runaway.servo.set_load(as_strong_at(15.0));
  runaway.servo.fail(ServoFault::hardover);
  runaway.run(0.05, pulse_us(0.0));
  EXPECT_NEAR(runaway.angle_deg(), 15.0 * (1.0 - std::exp(-rate_deg_s / 15.0 * 0.05)), 1e-9);
  runaway.run(2.0, pulse_us(0.0));
  EXPECT_NEAR(runaway.angle_deg(), 15.0, 1e-9);
  ServoRig jammed{strong_for_its_torque()};
  jammed.servo.set_load(as_strong_at(1.0));
  jammed.servo.fail(ServoFault::stuck, 20.0 * degree);
  jammed.run(1.0, pulse_us(0.0));
  EXPECT_NEAR(jammed.angle_deg(), 20.0, 1e-12);
}

TEST(ServoUnderLoad, CountsFromTheAngleAtWhichTheAirLeavesItAlone) {
  ServoRig rig{strong_for_its_torque()};
  ShaftLoad load = as_strong_at(15.0);
  load.free_angle_rad = -4.0 * degree;
  rig.servo.set_load(load);
  rig.run(2.0, pulse_us(40.0));
  EXPECT_NEAR(rig.angle_deg(), 11.0, 1e-9);
  rig.run(4.0, pulse_us(-40.0));
  EXPECT_NEAR(rig.angle_deg(), -19.0, 1e-9);
}

}  // namespace
}  // namespace fantail::sim
