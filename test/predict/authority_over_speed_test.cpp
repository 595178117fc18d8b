// SPDX-License-Identifier: MIT
#include "predict/authority_over_speed.hpp"

#include "input/scenario_file.hpp"
#include "predict/answer.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::radians;

Run with_offset(double begin_deg, double end_deg) {
  return {.seed = 1,
          .airframe = {.damping_m2 = 23.0,
                       .torque_m = 9.0,
                       .offset_begin_rad = radians(begin_deg),
                       .offset_end_rad = radians(end_deg)},
          .top_speed_m_s = 82.0};
}

// From 0.1 to -7 degrees in 1.7 s: -3.45 after half of it, whatever the sense of the other run.
TEST(AuthorityOverSpeed, NeedsTheOffsetOfTheTimeAtWhichTheSpeedIsReached) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const std::vector<predict::Run> runs{with_offset(0.1, -7.0), with_offset(-0.1, 7.0)};
  const auto all = authority_over_speed(scenario, runs, {{0.0, 0.0}, {0.85, 40.0}, {3.0, 80.0}}, radians(6.0));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(degrees(all[0].needed_rad.p50), 0.1, 1e-9);
  EXPECT_NEAR(degrees(all[1].needed_rad.p50), 3.45, 1e-9);
  EXPECT_NEAR(degrees(all[2].needed_rad.p95), 7.0, 1e-9);
  for (const AuthorityAtSpeed& at : all) {
    EXPECT_NEAR(degrees(at.given_rad), 6.0, 1e-12) << "no load on the servos";
  }
}

// 0.1 N m against 1/2 1.225 v^2 h u: at 100 m/s and 5e-5 m3 the air takes 0.30625 N m a radian, so 18.7 degrees are
// held, and at twice the speed a quarter of that.
TEST(AuthorityOverSpeed, GivesNoMoreThanTheServosHoldAgainstTheAir) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.servo.torque_n_m = 0.1;
  scenario.vehicle.canard_air.hinge_moment_m3 = -5e-5;  // in front of the shaft it pushes as hard
  const double density = scenario.atmosphere.density_kg_m3(0.0);
  const auto all =
      authority_over_speed(scenario, {with_offset(3.0, 3.0)}, {{0.0, 0.0}, {1.0, 100.0}, {2.0, 200.0}}, radians(9.0));
  EXPECT_NEAR(degrees(all[0].given_rad), 9.0, 1e-12) << "in still air";
  EXPECT_NEAR(degrees(all[1].given_rad), 9.0, 1e-12);
  EXPECT_NEAR(all[2].given_rad, 0.1 / (0.5 * density * 200.0 * 200.0 * 5e-5), 1e-12);
  EXPECT_LT(degrees(all[2].given_rad), 5.0);
}

TEST(AuthorityOverSpeed, TheClimbGoesFromLiftOffToTopSpeed) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const std::vector<SpeedAt> all = climb(scenario, with_offset(3.0, 3.0));
  ASSERT_GT(all.size(), 50U);
  EXPECT_LT(all.front().speed_m_s, 2.0);
  EXPECT_NEAR(all.front().after_liftoff_s, 0.0, 0.05);
  EXPECT_NEAR(all.back().speed_m_s, 82.0, 1.0);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GT(all[i].speed_m_s, all[i - 1].speed_m_s);
  }
  sim::Scenario heavy = scenario;
  heavy.vehicle.mass_kg = 1000.0;
  EXPECT_TRUE(climb(heavy, with_offset(3.0, 3.0)).empty());
}

TEST(CantChart, NeedsFinsAndCanardsInTheFileAndPutsTheOffsetOnItsLine) {
  Prediction p;
  p.flown = input::load_scenario("tasha3_launch2", {});
  p.offset_size_rad = {.p5 = radians(3.0), .p50 = radians(4.0), .p95 = radians(5.0)};
  p.reach.angle_rad = radians(9.0);
  p.runs = {with_offset(4.0, 4.0)};
  const auto chart = cant_chart(p);
  ASSERT_TRUE(chart);
  const page::Series& line = chart->series.at(0);
  const page::Series& offset = chart->series.at(1);
  EXPECT_EQ(offset.y.size(), 3U);
  EXPECT_NEAR(offset.y.at(1), 4.0, 1e-9);
  EXPECT_NEAR(offset.y.at(1) / offset.x.at(1), line.y.back() / line.x.back(), 1e-9);
  EXPECT_NEAR(chart->levels.at(0).value, 9.0, 1e-9);
  // Canards of half the torque need twice the angle for the same cant.
  const double by_whole_torque = line.y.back() / line.x.back();
  p.runs.front().airframe.torque_m *= 0.5;
  const auto weaker = cant_chart(p);
  ASSERT_TRUE(weaker);
  EXPECT_NEAR(weaker->series.at(0).y.back() / weaker->series.at(0).x.back(), 2.0 * by_whole_torque, 1e-9);
  p.flown.vehicle.geometry.reset();
  EXPECT_FALSE(cant_chart(p));
}

}  // namespace
}  // namespace fantail::predict
