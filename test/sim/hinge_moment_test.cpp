// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "jammed_canards.hpp"

namespace fantail::sim {
namespace {

constexpr double dynamic_pressure_pa = 0.5 * 1.2 * tunnel_m_s * tunnel_m_s;
constexpr double torque_n_m = 0.1;

/// In the tunnel at 22 m/s: fins that push as hard as canards at this angle, and a hinge moment that the servos hold up
/// to another angle.
Scenario loaded(double offset_deg, double holds_deg, const std::vector<std::string>& changes = {}) {
  std::vector<std::string> all{"tunnel.swirl_deg=0", "tunnel.turbulence=0", "reference.kind=hold",
                               "run.control_time_s=10", "servo.backlash_deg=0"};
  all.insert(all.end(), changes.begin(), changes.end());
  Scenario s = scenario("tunnel_steps", all);
  s.disturbance = {{.time_s = 0.0, .angle_rad = offset_deg * degree}};
  s.vehicle.servo.torque_n_m = torque_n_m;
  s.vehicle.canard_air.hinge_moment_m3 = torque_n_m / (dynamic_pressure_pa * holds_deg * degree);
  return s;
}

// The law asks for all of its 9 degrees, and the servos hold 5.
TEST(HingeMoment, EndsTheCanardsWhereItIsTheTorqueOfTheServo) {
  const FlownWorld flown = fly(loaded(-8.0, 5.0));
  EXPECT_NEAR(flown.at(9.9).truth.canard_rad / degree, 5.0, 1e-3);
  EXPECT_NEAR(flown.at(9.9).truth.roll_rate_rad_s / degree, tunnel_m_s * beta_m * (5.0 - 8.0) / alpha_m2, 0.01);
}

TEST(HingeMoment, WithinTheTorqueTheRollIsHeld) {
  const FlownWorld flown = fly(loaded(-4.0, 12.0));
  EXPECT_NEAR(flown.at(9.9).truth.canard_rad / degree, 4.0, 0.2);
  EXPECT_NEAR(flown.at(9.9).truth.roll_rate_rad_s / degree, 0.0, 1.0);
}

// Free of load is the trim, on each side of the rocket; a canard that is built in reversed turns the other way.
TEST(HingeMoment, TurnsEachCanardBackToItsTrim) {
  const Scenario s =
      loaded(-8.0, 5.0,
             {"canard_mounting.trim_deg=[2, 2, 2, 2]", "canards.trim_deg=[2, 2, 2, 2]",
              "canard_mounting.direction=[\"normal\", \"reversed\", \"normal\", \"reversed\"]",
              "canards.direction=[\"normal\", \"reversed\", \"normal\", \"reversed\"]", "encoder.noise_counts=0"});
  const FlownWorld flown = fly(s);
  const Tick& end = flown.at(9.9);
  EXPECT_NEAR(end.truth.canard_rad / degree, 5.0, 1e-3);
  EXPECT_NEAR(static_cast<double>(end.record.encoders[0]->radians()) / degree, 2.0 + 5.0, 0.03);
  EXPECT_NEAR(static_cast<double>(end.record.encoders[1]->radians()) / degree, 2.0 - 5.0, 0.03);
}

// The fins win, and the rocket rolls against its canards; so 0.5 m from the axis they meet the flow at more than their
// own angle d: d + x = 5 degrees with x = |p| r / v = (8 - d) beta r / alpha.
TEST(HingeMoment, IsThatOfTheAngleToTheFlow) {
  Scenario s = loaded(-8.0, 5.0);
  s.vehicle.canard_air.arm_m = 0.5;
  const double share = beta_m * 0.5 / alpha_m2;
  EXPECT_NEAR(fly(s).at(9.9).truth.canard_rad / degree, (5.0 - 8.0 * share) / (1.0 - share), 2e-3);
}

TEST(HingeMoment, NeedsTheTorqueOfTheServoToCount) {
  Scenario s = loaded(-8.0, 5.0);
  s.vehicle.servo.torque_n_m.reset();
  EXPECT_NEAR(fly(s).at(9.9).truth.canard_rad / degree, 8.0, 0.2);
}

}  // namespace
}  // namespace fantail::sim
