// SPDX-License-Identifier: MIT
#include "predict/canard_reach.hpp"

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "predict/run.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::radians;

TEST(CanardReach, IsWhatAllCanardsReachAndNamesWhatEndsThem) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  EXPECT_NEAR(degrees(canard_reach(scenario).angle_rad), 9.0, 1e-5);
  EXPECT_EQ(canard_reach(scenario).text(), "9 degree canard limit");
  EXPECT_NEAR(degrees(farthest_reach(scenario).angle_rad), 20.0, 1e-5);

  scenario.vehicle.servo.stop_rad = radians(8.0);
  EXPECT_NEAR(degrees(canard_reach(scenario).angle_rad), 8.0, 1e-12);
  EXPECT_EQ(canard_reach(scenario).text(), "8 degrees that the canards reach (servo stop)");

  scenario.plan.canards.each[1].mechanical_stop = core::Angle::from_degrees(7.0F);
  EXPECT_NEAR(degrees(canard_reach(scenario).angle_rad), 0.25 * (3.0 * 8.0 + 7.0), 1e-5);
  EXPECT_EQ(canard_reach(scenario).set_by, "mechanical stop of canard 2 in the plan");
  EXPECT_NEAR(degrees(farthest_reach(scenario).angle_rad), 0.25 * (3.0 * 8.0 + 7.0), 1e-5);

  scenario.plan.controller.canard_limit = core::Angle::from_degrees(30.0F);
  scenario.plan.canards.each[1].mechanical_stop = core::Angle::from_degrees(25.0F);
  scenario.vehicle.servo.stop_rad = radians(25.0);
  EXPECT_EQ(canard_reach(scenario).set_by, "hard limit");

  scenario.plan.controller.canard_limit = core::Angle::from_degrees(9.0F);
  scenario.plan.canards.each[0].trim = core::Angle::from_degrees(2.0F);
  EXPECT_NEAR(degrees(canard_reach(scenario).angle_rad), 0.25 * (3.0 * 9.0 + 7.0), 1e-5);
  EXPECT_EQ(canard_reach(scenario).set_by, "canard limit less the trim of the canards");
}

// The margin used to be that of the plan, 4.1 degrees, while the servos end at 4.5.
TEST(CanardReach, IsWhatTheAuthorityMarginOfARunIsMadeFrom) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.servo.stop_rad = radians(4.5);
  const double offset_rad = radians(-4.9);
  const auto run = fly_run(
      scenario, {.damping_m2 = 23.0, .torque_m = 9.0, .offset_begin_rad = offset_rad, .offset_end_rad = offset_rad}, 1);
  EXPECT_NEAR(degrees(run.authority_margin_rad), -0.4, 1e-9);
  EXPECT_FALSE(run.settle_rad);
  ASSERT_TRUE(run.spin_rate_rad_s);
  EXPECT_NEAR(*run.spin_rate_rad_s, -run.top_speed_m_s * 9.0 * radians(0.4) / 23.0, 1e-9);
}

}  // namespace
}  // namespace fantail::predict
