// SPDX-License-Identifier: MIT
// Numbers of the publication and of independent calculations: steady states, time constants and the tunnel step.

#include "core/flight_plan_fields.hpp"
#include "paper/closed_loop.hpp"
#include "test.hpp"

namespace fantail::paper {
namespace {

sim::RollPlant tunnel_plant(double area_m2 = reference_area_m2) {
  return {.inertia_kg_m2 = 0.00393, .reference_area_m2 = area_m2, .damping_m2 = 19.4, .torque_m = 9.6};
}

Loop tunnel_step(double limit_deg) {
  return {.plant = tunnel_plant(),
          .controller = gains(0.5, 0.05, limit_deg),
          .reference = hold(45),
          .excitation = core::default_plan().excitation,
          .disturbance = sim::Disturbance{{{0.0, -6.1 * radians_per_degree}}},
          .speed_m_s = [](double) { return 22.0; }};
}

constexpr double no_limit_deg = 90;

TEST(Oracle, Row01SteadyRollRateDoesNotDependOnTheReferenceArea) {
  for (const double area_m2 : {reference_area_m2, 1e-4, std::numbers::pi * 0.04 * 0.04}) {
    sim::RollState state{};
    for (int second = 0; second < 20; ++second) {
      state = tunnel_plant(area_m2).step(state, density_kg_m3, 22.0, radians_per_degree, 1.0);
    }
    EXPECT_NEAR(state.rate_rad_s / radians_per_degree, 10.887, 0.001 * 10.887);
  }
}

TEST(Oracle, Row02RollTimeConstantFallsWithSpeed) {
  EXPECT_NEAR(1.0 / tunnel_plant().damping_rate_per_s(density_kg_m3, 22.0), 0.30531, 1e-4);
  EXPECT_NEAR(1.0 / tunnel_plant().damping_rate_per_s(density_kg_m3, 30.0), 0.22390, 1e-4);
  EXPECT_NEAR(1.0 / tunnel_plant().damping_rate_per_s(density_kg_m3, 97.0), 0.06925, 1e-4);
}

TEST(Oracle, Row03ASteadyRollRateTellsTheEquivalentFinOffset) {
  // Eq 27: u = alpha p / (beta v); the plant under that offset must turn at that rate.
  const double offset_rad = -6.0625 * radians_per_degree;
  sim::RollState state{};
  for (int second = 0; second < 20; ++second) {
    state = tunnel_plant().step(state, density_kg_m3, 22.0, offset_rad, 1.0);
  }
  EXPECT_NEAR(state.rate_rad_s / radians_per_degree, -66.0, 66.0 * 1e-4 / 6.0625);
}

TEST(Oracle, Row04AnUnclampedTunnelStepSettlesAtTheReferencePlusOffsetOverGain) {
  const auto points = run(tunnel_step(no_limit_deg), 20.0);
  EXPECT_NEAR(points.back().angle_deg, 32.800, 0.05);
  EXPECT_NEAR(peak(points, 0, 20).angle_deg, 35.93, 0.05);
  EXPECT_NEAR(peak(points, 0, 20).time_s, 0.929, 0.02);
  EXPECT_NEAR(at(points, 1.0).angle_deg, 35.80, 0.05);
}

TEST(Oracle, Row05TheNineDegreeClampSlowsTheTunnelStep) {
  const auto points = run(tunnel_step(9), 5.0);
  EXPECT_NEAR(peak(points, 0, 5).angle_deg, 34.19, 0.1);
  EXPECT_NEAR(peak(points, 0, 5).time_s, 1.71, 0.02);
  EXPECT_NEAR(at(points, 1.0).angle_deg, 22.30, 0.1);
  EXPECT_NEAR(at(points, 5.0).angle_deg, 32.80, 0.1);
}

TEST(Oracle, Row06TheLiteralRateReferenceOfThePrintSettlesElsewhere) {
  Loop loop = tunnel_step(no_limit_deg);
  loop.controller.rate_reference = core::RateReference::paper_literal;
  EXPECT_NEAR(at(run(loop, 5.0), 5.0).angle_deg, 37.300, 0.02);
}

TEST(Oracle, Row07AnOffsetBeyondTheLimitRollsTheRocketAtASteadyRate) {
  const Loop loop{
      .plant = {.inertia_kg_m2 = 0.00361, .reference_area_m2 = reference_area_m2, .damping_m2 = 8.5, .torque_m = 10},
      .controller = gains(1, 0.1, 6),
      .reference = hold(0),
      .excitation = core::default_plan().excitation,
      .disturbance = sim::Disturbance{{{0.0, -7 * radians_per_degree}}},
      .speed_m_s = [](double) { return 60.0; }};
  const auto points = run(loop, 20.0);
  EXPECT_NEAR(points.back().rate_deg_s, -70.59, 0.002 * 70.59);
  EXPECT_FLOAT_EQ(static_cast<float>(points.back().command_deg), 6.0F);
}

TEST(Oracle, Row28TheGeometricReferenceAreaIsStiffAndStillDecays) {
  const sim::RollPlant stiff{
      .inertia_kg_m2 = 0.00361, .reference_area_m2 = std::numbers::pi * 0.04 * 0.04, .damping_m2 = 60, .torque_m = 10};
  sim::RollState state{.rate_rad_s = 1.0};
  for (int tick = 0; tick < 1000; ++tick) {
    const double before = state.rate_rad_s;
    state = stiff.step(state, density_kg_m3, 97.0, 0.0, 1e-3);
    ASSERT_GE(state.rate_rad_s, 0.0);
    ASSERT_LE(state.rate_rad_s, before);
  }
  EXPECT_LT(state.rate_rad_s, 1e-12);
}

}  // namespace
}  // namespace fantail::paper
