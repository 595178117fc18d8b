// SPDX-License-Identifier: MIT
#include "sim/rigid_body.hpp"

#include "sim/air_loads.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double pi = std::numbers::pi;
const double across_m = std::sqrt(0.04 / pi);  // of a cross-section of 0.01 m2

TEST(Rotation, SineAndCosineAreThoseOfTheLibraryAtEveryAngle) {
  for (double angle = -1000.0; angle < 1000.0; angle += 0.0137) {
    const auto [sine, cosine] = sine_cosine(angle);
    ASSERT_NEAR(sine, std::sin(angle), 1e-13) << angle;
    ASSERT_NEAR(cosine, std::cos(angle), 1e-13) << angle;
  }
  EXPECT_NEAR(sine_cosine(1e6).sine, std::sin(1e6), 1e-10);
}

TEST(Rotation, AnAngleOffAnAxisIsThatOfTheLibraryAllAround) {
  EXPECT_EQ(angle_off(0.0, 0.0), 0.0);
  for (double angle = 0.0; angle <= pi; angle += 0.00091) {
    ASSERT_NEAR(angle_off(7.0 * std::cos(angle), 7.0 * std::sin(angle)), angle, 1e-14) << angle;
  }
  EXPECT_NEAR(angle_off(-1.0, 0.0), pi, 1e-15);
}

TEST(Rotation, TurnsXToYAboutZAndBack) {
  const Quaternion quarter{.w = std::sqrt(0.5), .x = 0.0, .y = 0.0, .z = std::sqrt(0.5)};
  const Vector3 turned = rotated(quarter, {.x = 1.0});
  EXPECT_NEAR(turned.x, 0.0, 1e-15);
  EXPECT_NEAR(turned.y, 1.0, 1e-15);
  const Vector3 back = rotated_back(quarter, turned);
  EXPECT_NEAR(back.x, 1.0, 1e-15);
}

TEST(Rotation, ASmallOneIsExact) {
  const Vector3 angle{0.06, -0.05, 0.07};
  const double size = length(angle);
  const Quaternion q = small_rotation(angle);
  EXPECT_NEAR(q.w, std::cos(0.5 * size), 1e-15);
  EXPECT_NEAR(q.z, std::sin(0.5 * size) * 0.07 / size, 1e-15);
}

constexpr Inertia inertia{.mass_kg = 4.0, .transverse_kg_m2 = 0.6, .roll_kg_m2 = 0.004};

// A free top: without moments the pitch rate of the frame turns around with I_x p / I.
RigidState free_top(double time_s, int steps) {
  constexpr double spin_rad_s = 600.0;
  RigidState state{.position_m = {}, .velocity_m_s = {}, .attitude = {}, .rate_rad_s = {.y = 0.5}};
  const double dt_s = time_s / steps;
  const auto change = [](const RigidState& s, double) { return rate_of_change(s, {}, inertia, spin_rad_s); };
  for (int i = 0; i < steps; ++i) {
    state = stepped(state, change(state, 0.0), dt_s, change);
  }
  return state;
}

TEST(RigidBody, AFreeTopPrecessesAsTheClosedFormSays) {
  const double turn_rad = 0.004 * 600.0 / 0.6 * 2.0;
  const RigidState state = free_top(2.0, 20'000);
  EXPECT_NEAR(state.rate_rad_s.y, 0.5 * std::cos(turn_rad), 1e-6);
  EXPECT_NEAR(state.rate_rad_s.z, 0.5 * std::sin(turn_rad), 1e-6);
}

TEST(RigidBody, ErrorFallsWithTheSquareOfTheStep) {
  const RigidState exact = free_top(2.0, 200'000);
  const auto error = [&](int steps) {
    const RigidState found = free_top(2.0, steps);
    const Quaternion& a = found.attitude;
    const Quaternion& b = exact.attitude;
    return std::hypot(length(found.rate_rad_s - exact.rate_rad_s), a.w - b.w,
                      std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
  };
  const double coarse = error(200);
  EXPECT_GT(coarse, 1e-5);
  EXPECT_NEAR(std::log2(coarse / error(400)), 2.0, 0.05);
  EXPECT_NEAR(std::log2(error(400) / error(800)), 2.0, 0.05);
}

TEST(RigidBody, FallsFreely) {
  RigidState state{};
  const auto change = [](const RigidState& s, double) { return rate_of_change(s, {}, inertia, 0.0); };
  for (int i = 0; i < 1000; ++i) {
    state = stepped(state, change(state, 0.0), 1e-3, change);
  }
  EXPECT_NEAR(state.position_m.z, -0.5 * gravity_m_s2, 1e-9);
  EXPECT_NEAR(state.velocity_m_s.z, -gravity_m_s2, 1e-12);
}

// omega = v sqrt(rho A CN SM / 2 I): the pitch of a rocket pinned at its centre of gravity, without the damping.
TEST(AirLoads, RestoringMomentGivesThePitchFrequencyOfTheClosedForm) {
  Airframe airframe{.diameter_m = 0.08, .normal_force_slope_per_rad = 10.0, .centre_of_pressure_m = 1.02};
  for (const auto& [speed_m_s, omega_rad_s] : {std::pair{15.0, 1.17}, {20.0, 1.55}, {30.0, 2.33}}) {
    const double angle = 1e-4;  // the nose points towards -z of the flow: the flow comes from +z
    const Loads loads = air_loads(airframe, {.density_kg_m3 = 1.2,
                                             .drag_area_m2 = 0.0,
                                             .centre_of_gravity_m = 0.90,
                                             .air_speed_m_s = {.x = speed_m_s, .y = 0.0, .z = speed_m_s * angle},
                                             .rate_rad_s = {}});
    // A positive pitch moves the nose towards -z, so the angle of the nose against the flow is -angle of the flow.
    EXPECT_NEAR(std::sqrt(-loads.moment_n_m.y / angle / 0.6), omega_rad_s, 0.02) << speed_m_s;
    EXPECT_NEAR(loads.force_n.z, -0.5 * 1.2 * speed_m_s * speed_m_s * 10.0 * pi * 0.04 * 0.04 * angle, 1e-6);
  }
}

TEST(AirLoads, EveryPartDampsPitchWithTheSquareOfItsArm) {
  Airframe airframe{
      .diameter_m = across_m, .normal_force_slope_per_rad = 5.0, .centre_of_pressure_m = 1.0, .parts_spread_m = 0.3};
  // The same as two parts of half the slope at 0.7 and 1.3 m, each in its own flow.
  const double pitch_rad_s = 0.3;
  const double speed_m_s = 40.0;
  double moment_n_m = 0.0;
  for (const double position_m : {0.7, 1.3}) {
    const double arm_m = 0.9 - position_m;
    const double across_m_s = -pitch_rad_s * arm_m;
    const double force_n = -0.5 * 1.2 * speed_m_s * 0.025 * across_m_s;
    moment_n_m += -arm_m * force_n;
  }
  const Loads loads = air_loads(airframe, {.density_kg_m3 = 1.2,
                                           .drag_area_m2 = 0.0,
                                           .centre_of_gravity_m = 0.9,
                                           .air_speed_m_s = {.x = speed_m_s},
                                           .rate_rad_s = {.y = pitch_rad_s}});
  EXPECT_NEAR(loads.moment_n_m.y, moment_n_m, 1e-12);
  EXPECT_LT(loads.moment_n_m.y, 0.0);
}

// Everything that the parts do grows alike, their damping too; drag and the lift of the body do not.
TEST(AirLoads, TheFactorOnTheNormalForceIsThatOfThePartsAlone) {
  const Airframe parts{
      .diameter_m = across_m, .normal_force_slope_per_rad = 5.0, .centre_of_pressure_m = 1.0, .parts_spread_m = 0.3};
  InAir in_air{.density_kg_m3 = 1.2,
               .drag_area_m2 = 0.005,
               .centre_of_gravity_m = 0.9,
               .air_speed_m_s = {.x = 30.0, .y = 2.0, .z = -3.0},
               .rate_rad_s = {.x = 0.0, .y = 0.4, .z = 0.7}};
  const Loads slow = air_loads(parts, in_air);
  in_air.normal_force_factor = 1.25;
  const Loads fast = air_loads(parts, in_air);
  EXPECT_EQ(fast.force_n.x, slow.force_n.x);
  EXPECT_NEAR(fast.force_n.y, 1.25 * slow.force_n.y, 1e-12);
  EXPECT_NEAR(fast.force_n.z, 1.25 * slow.force_n.z, 1e-12);
  EXPECT_NEAR(fast.moment_n_m.y, 1.25 * slow.moment_n_m.y, 1e-12);
  EXPECT_NEAR(fast.moment_n_m.z, 1.25 * slow.moment_n_m.z, 1e-12);
  const Airframe body{.body_lift_area_m2 = 0.1, .body_lift_position_m = 0.7};
  const double with_factor_n = air_loads(body, in_air).force_n.z;
  in_air.normal_force_factor = 1.0;
  EXPECT_EQ(with_factor_n, air_loads(body, in_air).force_n.z);
}

TEST(AirLoads, AreTheSameWhicheverWayTheFlowComes) {
  Airframe airframe{.diameter_m = across_m,
                    .normal_force_slope_per_rad = 5.0,
                    .centre_of_pressure_m = 1.0,
                    .parts_spread_m = 0.3,
                    .body_lift_area_m2 = 0.1,
                    .body_lift_position_m = 0.7};
  const auto loads = [&](double y, double z) {
    return air_loads(airframe, {.density_kg_m3 = 1.2,
                                .drag_area_m2 = 0.005,
                                .centre_of_gravity_m = 0.9,
                                .air_speed_m_s = {.x = 30.0, .y = y, .z = z},
                                // pitching about the axis across the flow
                                .rate_rad_s = {.x = 0.0, .y = 0.1 * z, .z = -0.1 * y}});
  };
  const Loads in_z = loads(0.0, 5.0);
  const Loads in_y = loads(5.0, 0.0);
  const Loads between = loads(3.0, 4.0);
  EXPECT_NEAR(in_y.force_n.y, in_z.force_n.z, 1e-12);
  EXPECT_NEAR(in_y.moment_n_m.z, -in_z.moment_n_m.y, 1e-12);
  EXPECT_NEAR(between.force_n.y, 0.6 * in_z.force_n.z, 1e-12);
  EXPECT_NEAR(between.moment_n_m.y, 0.8 * in_z.moment_n_m.y, 1e-12);
  EXPECT_EQ(in_y.force_n.x, in_z.force_n.x);
}

TEST(AirLoads, TheBodysOwnLiftGrowsWithTheSquareOfTheCrossFlow) {
  Airframe airframe{.body_lift_area_m2 = 0.1, .body_lift_position_m = 0.7};
  const auto across_n = [&](double z) {
    return air_loads(airframe, {.density_kg_m3 = 1.2,
                                .drag_area_m2 = 0.0,
                                .centre_of_gravity_m = 0.9,
                                .air_speed_m_s = {.x = 30.0, .y = 0.0, .z = z},
                                .rate_rad_s = {}})
        .force_n.z;
  };
  EXPECT_NEAR(across_n(10.0), -0.5 * 1.2 * 0.1 * 100.0, 1e-12);
  EXPECT_NEAR(across_n(-20.0), 0.5 * 1.2 * 0.1 * 400.0, 1e-12);
}

}  // namespace
}  // namespace fantail::sim
