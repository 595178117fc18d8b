// SPDX-License-Identifier: MIT

#include "jammed_canards.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "sim/deflection_range.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr CanardAerodynamics stalling{.stall_rad = 12.0 * degree, .arm_m = 0.08};

TEST(CanardStall, LiftIsInProportionToTheAngleUpToTheStallAndStaysThereBeyond) {
  for (const double angle_deg : {-11.9, -3.0, 0.0, 0.1, 12.0}) {
    EXPECT_EQ(lift_angle_rad(stalling, angle_deg * degree), angle_deg * degree);
  }
  EXPECT_EQ(lift_angle_rad(stalling, 12.1 * degree), 12.0 * degree);
  EXPECT_EQ(lift_angle_rad(stalling, 80.0 * degree), 12.0 * degree);
  EXPECT_EQ(lift_angle_rad(stalling, -20.0 * degree), -12.0 * degree);
  EXPECT_EQ(lift_angle_rad({}, 80.0 * degree), 80.0 * degree);
}

TEST(CanardStall, RollMakesTheAngleOfItsSpeedAtTheCanardOverTheAirSpeed) {
  // 10 rad/s at 0.08 m are 0.8 m/s across.
  EXPECT_DOUBLE_EQ(angle_of_roll_rad(stalling, 10.0, 40.0), -0.02);
  EXPECT_DOUBLE_EQ(angle_of_roll_rad(stalling, -10.0, 40.0), 0.02);
  EXPECT_DOUBLE_EQ(angle_of_roll_rad(stalling, 10.0, -40.0), -0.02) << "it damps in air from behind, too";
  EXPECT_EQ(angle_of_roll_rad(stalling, 10.0, 0.0), 0.0);
  EXPECT_EQ(angle_of_roll_rad({.stall_rad = 0.2}, 10.0, 40.0), 0.0);
}

// 0.02 rad are 1.146 degrees: at 13 degrees of the shaft the flow comes at 11.854, which is below the stall.
TEST(CanardStall, IsReachedByTheAngleToTheFlowAndNotByThatOfTheShaft) {
  const double of_roll_rad = angle_of_roll_rad(stalling, 10.0, 40.0);
  EXPECT_EQ(torque_angle_rad(stalling, 13.0 * degree, of_roll_rad), 13.0 * degree);
  EXPECT_EQ(torque_angle_rad(stalling, -10.5 * degree, of_roll_rad), -10.5 * degree);
  // 14 degrees stall, and so do -11: lift 12 degrees; the damping of the canards that is in alpha is taken off.
  EXPECT_NEAR(torque_angle_rad(stalling, 14.0 * degree, of_roll_rad), 12.0 * degree + 0.02, 1e-15);
  EXPECT_NEAR(torque_angle_rad(stalling, -11.0 * degree, of_roll_rad), -12.0 * degree + 0.02, 1e-15);
}

TEST(CanardStall, EveryCanardStallsByItself) {
  const Scenario s = jammed({10.0, -2.0, 20.0, 15.0}, {"aerodynamics.canard_stall_deg=12"});
  EXPECT_NEAR(steady_rate_deg_s(s), tunnel_m_s * beta_m * 0.25 * (10.0 - 2.0 + 12.0 + 12.0) / alpha_m2, 1e-6);
}

TEST(CanardStall, IsAbsentWithoutItsField) {
  const std::array<double, 4> angles_deg{10.0, -2.0, 20.0, 15.0};
  const double linear_deg_s = tunnel_m_s * beta_m * 0.25 * (10.0 - 2.0 + 20.0 + 15.0) / alpha_m2;
  EXPECT_NEAR(steady_rate_deg_s(jammed(angles_deg)), linear_deg_s, 1e-6);
  EXPECT_NEAR(steady_rate_deg_s(jammed(angles_deg, {"aerodynamics.canard_arm_m=0.08"})), linear_deg_s, 1e-6);
}

// At 20 degrees all four stall; the damping that is left is that of the fins, alpha - beta r.
TEST(CanardStall, AStalledCanardDampsNoRoll) {
  const std::vector<std::string> changes{"aerodynamics.canard_stall_deg=12", "aerodynamics.canard_arm_m=0.08"};
  EXPECT_NEAR(steady_rate_deg_s(jammed({20.0, 20.0, 20.0, 20.0}, changes)),
              tunnel_m_s * beta_m * 12.0 / (alpha_m2 - beta_m * 0.08), 1e-6);
  EXPECT_NEAR(steady_rate_deg_s(jammed({-6.0, -6.0, -6.0, -6.0}, changes)), tunnel_m_s * beta_m * -6.0 / alpha_m2, 1e-6)
      << "below the stall nothing changes";
}

TEST(CanardStall, CountsFromTheTrimAndInTheSenseOfTheCanard) {
  const Scenario s =
      jammed({14.0, -14.0, 9.0, -30.0},
             {"aerodynamics.canard_stall_deg=12", "canard_mounting.trim_deg=[3, -1, 0, 0]",
              "canard_mounting.direction=[\"normal\", \"reversed\", \"normal\", \"reversed\"]", "servo.stop_deg=30"});
  // From their trims 11, 13, 9 and 30 degrees, all in the sense of positive roll.
  EXPECT_NEAR(steady_rate_deg_s(s), tunnel_m_s * beta_m * 0.25 * (11.0 + 12.0 + 9.0 + 12.0) / alpha_m2, 1e-6);
}

TEST(CanardStall, EndsTheAuthority) {
  Scenario s = scenario("tasha3_launch2", {"controller.canard_limit_deg=20", "aerodynamics.canard_stall_deg=12"});
  EXPECT_NEAR(deflection_range(s).highest_rad / degree, 12.0, 1e-12);
  EXPECT_NEAR(deflection_range(s).lowest_rad / degree, -12.0, 1e-12);
  EXPECT_NEAR(canard_response(s).effectiveness, 1.0, 1e-6);
  s.vehicle.canards[2].trim_rad = 10.0 * degree;
  EXPECT_NEAR(deflection_range(s).highest_rad / degree, 0.25 * (3.0 * 12.0 + 10.0), 1e-6);
  EXPECT_NEAR(deflection_range(s).lowest_rad / degree, -12.0, 1e-12);
}

// What the margin says is what the world flies: an offset of 13 degrees is a degree more than the canards can balance.
TEST(CanardStall, LeavesTheOffsetThatTheMarginSays) {
  const auto rate_deg_s = [](const char* offset_deg) {
    return fly("tunnel_steps", {std::string{"disturbance.angles_deg=["} + offset_deg + "]", "tunnel.swirl_deg=0",
                                "tunnel.turbulence=0", "reference.kind=hold", "run.control_time_s=10",
                                "controller.canard_limit_deg=20", "aerodynamics.canard_stall_deg=12"})
               .at(9.9)
               .truth.roll_rate_rad_s /
           degree;
  };
  EXPECT_NEAR(rate_deg_s("-13"), tunnel_m_s * beta_m * -1.0 / alpha_m2, 1e-3);
  EXPECT_NEAR(rate_deg_s("11"), 0.0, 0.5);
}

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
