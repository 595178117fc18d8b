// SPDX-License-Identifier: MIT
#include "sim/gimbal.hpp"

#include "degree.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

Gimbal turned(const std::vector<HandTurn>& turns, double until_s, double step_s = 1e-3) {
  Gimbal gimbal{turns};
  for (int i = 1; step_s * i <= until_s + 1e-9; ++i) {
    gimbal.step(step_s * i, step_s);
  }
  return gimbal;
}

TEST(Gimbal, ATurnHasItsAngleAndEndsAtRest) {
  const std::vector<HandTurn> turns{{.time_s = 1.0, .duration_s = 2.0, .angle_rad = {.x = 90.0 * degree}}};
  const Gimbal before = turned(turns, 1.0);
  EXPECT_EQ(before.roll_angle_rad(), 0.0);
  EXPECT_NEAR(turned(turns, 2.0).motion().rate_rad_s.x, 90.0 * degree, 1e-9) << "twice the mean rate, half-way";
  const Gimbal after = turned(turns, 3.5);
  EXPECT_NEAR(after.roll_angle_rad(), 90.0 * degree, 1e-6);
  EXPECT_EQ(after.motion().rate_rad_s.x, 0.0);
}

// Up in the body of a rocket whose nose was tipped about y by 90 degrees is z; about z it is -y.
TEST(Gimbal, GravityIsFeltWhereTheRocketWasTipped) {
  const BodyMotion pitched =
      turned({{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.y = 90.0 * degree}}}, 2.0).motion();
  EXPECT_NEAR(pitched.specific_force_m_s2.x, 0.0, 1e-5);
  EXPECT_NEAR(pitched.specific_force_m_s2.z, gravity_m_s2, 1e-5);
  const BodyMotion yawed =
      turned({{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.z = 90.0 * degree}}}, 2.0).motion();
  EXPECT_NEAR(yawed.specific_force_m_s2.y, -gravity_m_s2, 1e-5);
}

// Pitch, then roll by 90 degrees, then pitch again: not the sum of the turns.
TEST(Gimbal, TurnsAreAboutTheAxesOfTheBodyAsItStands) {
  const double quarter = 90.0 * degree;
  const Gimbal gimbal = turned({{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.y = quarter}},
                                {.time_s = 1.0, .duration_s = 1.0, .angle_rad = {.x = quarter}},
                                {.time_s = 2.0, .duration_s = 1.0, .angle_rad = {.y = quarter}}},
                               4.0);
  // The nose lies along -z of the earth after the first turn, and the third is about the earth's x axis there.
  const Vector3 nose = rotated(gimbal.attitude(), {.x = 1.0, .y = 0.0, .z = 0.0});
  EXPECT_NEAR(nose.x, 0.0, 1e-5);
  EXPECT_NEAR(std::abs(nose.y), 1.0, 1e-5);
}

TEST(Gimbal, RatesAreTheIntegralOfTheAccelerationsThatAnOffsetSensorFeels) {
  const std::vector<HandTurn> turns{{.time_s = 0.0, .duration_s = 2.0, .angle_rad = {.z = 1.0}}};
  Gimbal gimbal{turns};
  double rate_rad_s = 0.0;
  for (int i = 1; i <= 700; ++i) {
    const double before = gimbal.motion().angular_acceleration_rad_s2.z;
    gimbal.step(1e-3 * i, 1e-3);
    rate_rad_s += 0.5e-3 * (before + gimbal.motion().angular_acceleration_rad_s2.z);
  }
  EXPECT_NEAR(gimbal.motion().rate_rad_s.z, rate_rad_s, 1e-6);
}

TEST(Gimbal, ErrorOfTheAttitudeFallsWithTheSquareOfTheStep) {
  const std::vector<HandTurn> turns{{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.y = 2.0}}};
  const auto up = [&turns](double step_s) { return turned(turns, 0.6, step_s).motion().specific_force_m_s2.z; };
  const double exact = up(1e-4);
  EXPECT_NEAR(std::log2((up(0.02) - exact) / (up(0.01) - exact)), 2.0, 0.1);
}

// ---- let go ----

constexpr FreeTurning tasha{.roll_inertia_kg_m2 = 0.005, .transverse_inertia_kg_m2 = 0.6, .friction_n_m = 0.01};

Gimbal let_go(const std::vector<HandTurn>& turns, double until_s, const FreeTurning& free) {
  Gimbal gimbal{turns, free};
  for (int i = 1; 1e-3 * i <= until_s + 1e-9; ++i) {
    gimbal.step(1e-3 * i, 1e-3);
  }
  return gimbal;
}

// Twice the mean rate half-way, w0 = 2 angle / duration; then it stops after I w0 / T, having turned I w0^2 / 2 T.
TEST(Gimbal, FrictionStopsARocketThatWasLetGo) {
  const std::vector<HandTurn> turns{{.time_s = 0.0, .duration_s = 2.0, .angle_rad = {.x = 1.0}}};
  const double stops_s = 1.0 + 0.005 * 1.0 / 0.01;
  EXPECT_NEAR(let_go(turns, 1.0, tasha).motion().rate_rad_s.x, 1.0, 1e-5);
  EXPECT_NEAR(let_go(turns, 1.25, tasha).motion().rate_rad_s.x, 0.5, 0.003);
  EXPECT_GT(let_go(turns, stops_s - 0.01, tasha).motion().rate_rad_s.x, 0.0);
  const Gimbal after = let_go(turns, stops_s + 0.01, tasha);
  EXPECT_EQ(after.motion().rate_rad_s.x, 0.0);
  EXPECT_NEAR(after.roll_angle_rad(), 0.5 + 0.005 / (2.0 * 0.01), 1e-3);
}

// Free of friction the rates across go round at p (It - Ix) / It; angular momentum stays where it points in the room.
TEST(Gimbal, ARocketThatRollsAndTiltsFreelyPrecesses) {
  const FreeTurning free{.roll_inertia_kg_m2 = 0.2, .transverse_inertia_kg_m2 = 0.6, .friction_n_m = 0.0};
  const std::vector<HandTurn> turns{{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.x = 1.5, .y = 0.25}}};
  const auto momentum = [&free](const Gimbal& gimbal) {
    const Vector3 rate_rad_s = gimbal.motion().rate_rad_s;
    return rotated(gimbal.attitude(), {.x = free.roll_inertia_kg_m2 * rate_rad_s.x,
                                       .y = free.transverse_inertia_kg_m2 * rate_rad_s.y,
                                       .z = free.transverse_inertia_kg_m2 * rate_rad_s.z});
  };
  const Gimbal begin = let_go(turns, 0.5, free);
  const double precession_rad_s = begin.motion().rate_rad_s.x * (0.6 - 0.2) / 0.6;
  const double quarter_s = 0.5 * std::numbers::pi / precession_rad_s;
  const double steps_s = 1e-3 * std::round(quarter_s / 1e-3);
  const Gimbal later = let_go(turns, 0.5 + steps_s, free);
  EXPECT_NEAR(later.motion().rate_rad_s.x, begin.motion().rate_rad_s.x, 1e-9);
  EXPECT_NEAR(later.motion().rate_rad_s.z, -begin.motion().rate_rad_s.y, 1e-3);
  EXPECT_NEAR(later.motion().rate_rad_s.y, 0.0, 1e-3);
  EXPECT_NEAR(length(momentum(later) - momentum(begin)), 0.0, 1e-4 * length(momentum(begin)));
}

TEST(Gimbal, TheNextTurnTakesHoldOfARocketThatStillTurns) {
  const std::vector<HandTurn> turns{{.time_s = 0.0, .duration_s = 1.0, .angle_rad = {.y = 1.0}},
                                    {.time_s = 2.0, .duration_s = 1.0, .angle_rad = {.x = 1.0}}};
  EXPECT_GT(let_go(turns, 2.0, tasha).motion().rate_rad_s.y, 1.9);
  EXPECT_EQ(let_go(turns, 2.2, tasha).motion().rate_rad_s.y, 0.0);
}

}  // namespace
}  // namespace fantail::sim
