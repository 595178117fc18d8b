// SPDX-License-Identifier: MIT
// Canards that do not turn the rocket as the law commands them: no gains, no limit and no straighter fins would help.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "predict/decision.hpp"

namespace fantail::predict {
namespace {

TEST(WrongWay, CanardsThatTurnTheWrongWayAreTheCauseAndNeitherOffsetNorGains) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (core::CanardPlan& canard : scenario.plan.canards.each) {
    canard.direction = core::Direction::reversed;
  }
  const TunnelResult tunnel = read_tunnel_result(scenario.tunnel_result.value(), {});
  const Decision d = decide(predict(scenario, tunnel, {.runs = 4}, [](std::size_t) {}), {});
  EXPECT_FALSE(d.go);
  EXPECT_TRUE(
      d.text.starts_with("No go: all canards turn the rocket against the roll command (direction differs "
                         "between plan and vehicle); roll is held in none of the runs"))
      << d.text;
  EXPECT_EQ(d.text.find(" gains"), std::string::npos) << d.text;
  EXPECT_EQ(d.text.find("fin offset"), std::string::npos) << d.text;
  ASSERT_EQ(d.advice.size(), 1U);
  EXPECT_TRUE(d.advice[0].starts_with("No canard limit would balance the offset: all canards turn")) << d.advice[0];
}

TEST(WrongWay, PromisesNothingWhereTheFinsReverseTheRoll) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.canard_air.wash = 1.2;
  scenario.vehicle.canard_air.wash_distance_m = 0.9;
  const TunnelResult tunnel = read_tunnel_result(scenario.tunnel_result.value(), {});
  const Prediction p = predict(scenario, tunnel, {.runs = 20}, [](std::size_t) {});
  EXPECT_TRUE(std::ranges::any_of(p.notes, [](const std::string& note) {
    return note.find("the fins take 1.2 times of it back") != std::string::npos;
  }));
  EXPECT_EQ(p.authority.count, 0U);
  EXPECT_EQ(p.held.count, 0U);
  const Decision d = decide(p, {.authority_share = 0.5, .held_share = 0.5});
  EXPECT_FALSE(d.go);
  EXPECT_NE(d.text.find("the fins take back all of the canards' roll torque, or more"), std::string::npos) << d.text;
  ASSERT_EQ(d.advice.size(), 1U);
  EXPECT_NE(d.advice[0].find("No canard limit would balance the offset"), std::string::npos) << d.advice[0];
}

}  // namespace
}  // namespace fantail::predict
