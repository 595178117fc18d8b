// SPDX-License-Identifier: MIT
#include "stability/speed_range.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fly/loop_margins.hpp"
#include "input/scenario_file.hpp"
#include "stability/roll_loop.hpp"
#include "text/degrees.hpp"

namespace fantail::stability {
namespace {

sim::Scenario with_schedule(float low, float middle, float high) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.plan.gain_schedule = {
      .speeds_count = 3, .speeds_m_s = {20.0F, 50.3F, 80.0F}, .factors_count = 3, .factors = {low, middle, high}};
  return scenario;
}

TEST(SpeedRange, HasTheRowsOfTheScheduleThatLieInside) {
  const sim::Scenario scenario = with_schedule(1.0F, 1.0F, 1.0F);
  const std::vector<double> speeds = speeds_between(scenario.plan, {40.0, 60.0}, 2);
  ASSERT_EQ(speeds.size(), 4U);
  EXPECT_EQ(speeds[0], 40.0);
  EXPECT_EQ(speeds[1], 50.0);
  EXPECT_NEAR(speeds[2], 50.3, 1e-5);
  EXPECT_EQ(speeds[3], 60.0);
}

// Good at both ends of the range: only between them is the gain too large.
TEST(SpeedRange, ALoopThatIsUnstableOnlyBetweenTheEndsIsFound) {
  const sim::Scenario scenario = with_schedule(1.0F, 60.0F, 1.0F);
  ASSERT_GT(*phase_margin_rad(loop_at_speed(scenario, 20.0)), 0.5);
  ASSERT_GT(*phase_margin_rad(loop_at_speed(scenario, 80.0)), 0.5);
  const MarginsInRange found = margins_in_range(scenario, {20.0, 80.0});
  ASSERT_TRUE(found.first_without && found.least);
  EXPECT_NEAR(found.least->speed_m_s, 50.3, 6.0);
  EXPECT_LT(found.least->phase_margin_rad, found.first_without->phase_margin_rad);
  EXPECT_GT(*phase_margin_rad(loop_at_speed(scenario, found.first_without->speed_m_s - 0.6)), 0.0);
  EXPECT_FALSE(margins_in_range(with_schedule(1.0F, 1.0F, 1.0F), {20.0, 80.0}).first_without);
}

// The gain goes with v^2 (1.16 - 0.00533 v) between the rows, so it is largest near 145 m/s, where no row is.
TEST(SpeedRange, AFlightFindsTheSameWorstSpeedAsACheckOfItsPlan) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.plan.gain_schedule = {
      .speeds_count = 2, .speeds_m_s = {30.0F, 180.0F}, .factors_count = 2, .factors = {20.0F, 4.0F}};
  const SpeedRange range{60.0, 187.3};
  const MarginAtSpeed checked = margins_in_range(scenario, range).least.value();
  const auto flown = fly::loop_margins(scenario, {range.lowest_m_s, 90.0, range.highest_m_s});
  const auto worst = std::ranges::min_element(flown, {}, &flight::LoopMargin::phase_margin_rad);
  EXPECT_EQ(worst->speed_m_s, checked.speed_m_s);
  EXPECT_EQ(worst->phase_margin_rad, checked.phase_margin_rad);
  EXPECT_NEAR(checked.speed_m_s, 145.0, 20.0);
}

}  // namespace
}  // namespace fantail::stability
