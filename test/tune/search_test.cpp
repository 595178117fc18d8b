// SPDX-License-Identifier: MIT
#include "tune/search.hpp"

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "stability/roll_loop.hpp"
#include "tune/flights.hpp"
#include "tune/linear_trial.hpp"

namespace fantail::tune {
namespace {

const SpeedsFlown speeds = speeds_flown({20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0});

void look_away() {}

// Looked at without the search's own loops.
TEST(Search, WhatItFindsHasTheMarginAndSettlesInTimeEverywhere) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Request request{.schedule = true, .spread = 1.2};
  const Found found = search(scenario, speeds, request, look_away);
  ASSERT_FALSE(found.laws.empty());
  for (const Law& law : found.laws) {
    for (sim::Scenario airframe : corners(scenario, request.spread)) {
      airframe.plan = with_law(scenario, request.rejection, law, speeds.range);
      for (const double speed_m_s : {20.0, 35.0, 50.0, 65.0, 80.0}) {
        const auto margin = stability::phase_margin_rad(stability::loop_at_speed(airframe, speed_m_s));
        EXPECT_GT(margin.value(), request.phase_margin_rad - 0.01) << speed_m_s;
      }
      for (const double speed_m_s : {50.0, 80.0}) {
        EXPECT_TRUE(settling_s(stability::loop_at_speed(airframe, speed_m_s), request.settling_s)) << speed_m_s;
      }
    }
  }
}

TEST(Search, AWiderSpreadLeavesASlowerLaw) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Found narrow = search(scenario, speeds, {.spread = 1.0}, look_away);
  const Found wide = search(scenario, speeds, {.spread = 2.0}, look_away);
  ASSERT_FALSE(narrow.laws.empty());
  EXPECT_TRUE(wide.laws.empty() || wide.laws.front().integral_gain_per_s < narrow.laws.front().integral_gain_per_s);
}

TEST(Search, FindsNoScheduleThatAPlanDoesNotAllow) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const SpeedsFlown wide = speeds_flown({8.0, 30.0, 50.0, 80.0, 110.0});
  const Found found = search(scenario, wide, {.schedule = true, .spread = 1.0}, look_away);
  for (const Law& law : found.laws) {
    EXPECT_NO_THROW((void)with_law(scenario, Request{}.rejection, law, wide.range)) << law.schedule_exponent;
  }
  ASSERT_FALSE(found.laws.empty());
}

TEST(Search, SaysHowMuchPhaseMarginThereIs) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Found found = search(scenario, speeds, {.phase_margin_rad = text::radians(120.0)}, look_away);
  EXPECT_TRUE(found.laws.empty());
  EXPECT_FALSE(found.phase_margin_is_there);
  EXPECT_GT(found.most.phase_margin_rad, text::radians(45.0));
  EXPECT_LT(found.most.phase_margin_rad, text::radians(120.0));
}

TEST(SpeedsFlown, AreEvenInTime) {
  const SpeedsFlown found = speeds_flown({80.0, 20.0, 50.0, 50.0, 50.0});
  EXPECT_EQ(found.range.lowest_m_s, 20.0);
  EXPECT_EQ(found.range.highest_m_s, 80.0);
  EXPECT_EQ(found.median_m_s, 50.0);
}

}  // namespace
}  // namespace fantail::tune
