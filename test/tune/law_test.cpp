// SPDX-License-Identifier: MIT
#include "tune/law.hpp"

#include <regex>

#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "stability/roll_loop.hpp"
#include "test.hpp"
#include "text/error.hpp"
#include "tune/bound.hpp"
#include "tune/flights.hpp"
#include "tune/linear_trial.hpp"
#include "tune/search.hpp"

namespace fantail::tune {
namespace {

using core::OffsetRejection;

TEST(Law, OfAScheduleHasFactorsThatFallWithThePowerOfTheSpeed) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Law law{.gains = {0.5, 0.05}, .integral_gain_per_s = 0.3, .schedule_exponent = 1.5};
  const core::FlightPlan plan = with_law(scenario, OffsetRejection::integral, law, {20.0, 80.0});
  ASSERT_EQ(plan.gain_schedule.speeds_count, 6);
  EXPECT_EQ(plan.gain_schedule.speeds_m_s[0], 20.0F);
  EXPECT_EQ(plan.gain_schedule.speeds_m_s[5], 80.0F);
  EXPECT_NEAR(plan.gain_schedule.factors[0], 8.0, 1e-6);
  EXPECT_EQ(plan.gain_schedule.factors[5], 1.0F);
  EXPECT_EQ(plan.offset.integral_gain_per_s, 0.3F);
  EXPECT_EQ(with_law(scenario, OffsetRejection::integral, law, {22.0, 22.1}).gain_schedule.speeds_count, 0);
}

TEST(Law, AnObserverGetsTheRollModelOfTheVehicle) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const core::FlightPlan plan = with_law(scenario, OffsetRejection::observer,
                                         {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0}, {20.0, 80.0});
  EXPECT_EQ(plan.roll_model.damping_m2, 23.0F);
  EXPECT_EQ(plan.roll_model.torque_m, 9.0F);
  EXPECT_NEAR(plan.roll_model.density_kg_m3, 1.225, 1e-3);
}

TEST(Law, AnObserverGetsTheRollInertiaAfterBurnOut) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const auto inertia_kg_m2 = [&] {
    return with_law(scenario, OffsetRejection::observer, {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0},
                    {20.0, 80.0})
        .roll_model.roll_inertia_kg_m2;
  };
  EXPECT_EQ(inertia_kg_m2(), 0.00393F);  // as at lift-off: the vehicle says nothing else
  scenario.vehicle.airframe = sim::Airframe{.roll_inertia_after_burnout_kg_m2 = 0.0035};
  EXPECT_EQ(inertia_kg_m2(), 0.0035F);
}

TEST(Law, BehindAGateLaterThanTheGuideBeginsByCaptureWithTheRollModelOfTheVehicle) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const auto plan = [&] { return with_law(scenario, OffsetRejection::none, {.gains = {0.5, 0.05}}, {20.0, 80.0}); };
  EXPECT_EQ(plan().controller.entry, core::ControlEntry::as_published);
  EXPECT_EQ(plan().roll_model.torque_m, 0.0F);
  scenario.plan.dormancy.until = core::DormantUntil::max_dynamic_pressure;
  EXPECT_EQ(plan().dormancy.until, core::DormantUntil::max_dynamic_pressure);
  EXPECT_EQ(plan().controller.entry, core::ControlEntry::capture);
  EXPECT_EQ(plan().roll_model.torque_m, 9.0F);
}

TEST(Law, WithoutAKnownSpeedThereIsNoObserver) {
  const sim::Scenario scenario = input::load_scenario("tunnel_steps", {});
  EXPECT_THROW((void)with_law(scenario, OffsetRejection::observer,
                              {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0}, {22.0, 22.0}),
               text::Error);
}

// From 12 m/s to 144 m/s the square of the ratio is 144, and a plan allows 100; from 14.4 m/s on it is 100.
TEST(Law, ASteepScheduleThatNoPlanAllowsIsLeftOutWithTheSpeedThatWouldAllowIt) {
  const stability::SpeedRange wide{12.0, 144.0};
  EXPECT_TRUE(stability::is_within_plan(1.5, wide));  // 41.6
  EXPECT_FALSE(stability::is_within_plan(2.0, wide));
  EXPECT_EQ(figures(schedules_left_out(wide)), (std::vector<std::string>{"2", "144", "12.0", "100", "14.4"}));
  EXPECT_EQ(schedules_left_out({14.4, 144.0}), "");
  EXPECT_EQ(schedules_left_out({14.4, 14.5}), "");
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (const double exponent : stability::schedule_exponents) {
    const Law law{.gains = {0.5, 0.05}, .schedule_exponent = exponent};
    EXPECT_NO_THROW((void)with_law(scenario, OffsetRejection::none, law, {14.4, 144.0})) << exponent;
  }
}

// s^2 + (a + b kd) s + b kp with two equal poles at -w: 1 - (1 + w t) e^(-w t), within a tenth from w t = 3.8897 on.
TEST(LinearStep, OfALoopWithTwoEqualPolesIsTheTextbooks) {
  constexpr double w = 5.0;
  const stability::RollLoop loop{.proportional_gain = w * w / 100.0,
                                 .derivative_gain_s = (2.0 * w - 4.0) / 100.0,
                                 .damping_rate_per_s = 4.0,
                                 .authority_per_s2 = 100.0};
  const std::vector<double> angles = step_response(loop, 2.0);
  for (const std::size_t i : {99U, 499U, 999U}) {
    const double t = 1e-3 * static_cast<double>(i + 1);
    EXPECT_NEAR(angles[i], 1.0 - (1.0 + w * t) * std::exp(-w * t), 2e-3) << t;
  }
  EXPECT_NEAR(settling_s(loop, 2.0).value(), 3.8897 / w, 2e-3);
  EXPECT_FALSE(settling_s(loop, 0.5));
}

// An integral that is slow beside the loop: its pole is near -ki / kp.
TEST(LinearStep, IntegralActionComesBackFromItsOvershootWithItsOwnTime) {
  stability::RollLoop loop{.proportional_gain = 0.5,
                           .derivative_gain_s = 0.1,
                           .integral_gain_per_s = 0.1,
                           .damping_rate_per_s = 5.0,
                           .authority_per_s2 = 500.0};
  const std::vector<double> angles = step_response(loop, 10.0);
  EXPECT_GT(angles[1999], 1.0);
  EXPECT_NEAR((angles[6999] - 1.0) / (angles[1999] - 1.0), std::exp(-0.2 * 5.0), 0.05);
}

TEST(LinearStep, ALoopThatSwingsNeverSettles) {
  const stability::RollLoop loop{.proportional_gain = 5.0,
                                 .derivative_gain_s = 0.02,
                                 .damping_rate_per_s = 3.0,
                                 .authority_per_s2 = 500.0,
                                 .servo_lag_s = 0.02,
                                 .delay_s = 0.005};
  ASSERT_LT(*stability::phase_margin_rad(loop), 0.0);
  EXPECT_FALSE(settling_s(loop, 5.0));
}

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

// Each sentence against loops that are made anew from the plan.
TEST(Bound, NamesADemandThatTheNextLargerNumberMissesAndALittleLessDoesNot) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Request request{.spread = 1.2};
  const Found found = search(scenario, speeds, request, look_away);
  ASSERT_FALSE(found.laws.empty());
  std::size_t by_phase = 0;
  for (const Law& law : found.laws) {
    const std::string said = bound_sentence(scenario, speeds, request, 0.0, law);
    std::smatch words;
    if (!std::regex_search(
            said, words,
            std::regex{"integral gain of ([0-9.]+) 1/s \\(now ([0-9.]+)\\), the phase margin at ([0-9]+) "
                       "m/s would be ([0-9.]+) degrees"})) {
      continue;
    }
    ++by_phase;
    EXPECT_NEAR(std::stod(words[2]), law.integral_gain_per_s, 0.01 * law.integral_gain_per_s) << said;
    Law more = law;
    more.integral_gain_per_s = std::stod(words[1]);
    double least_rad = 3.0;
    for (sim::Scenario airframe : corners(scenario, request.spread)) {
      airframe.plan = with_law(scenario, request.rejection, more, speeds.range);
      const auto loop = stability::loop_at_speed(airframe, std::stod(words[3]));
      least_rad = std::min(least_rad, stability::phase_margin_rad(loop).value_or(3.0));
    }
    EXPECT_LT(least_rad, request.phase_margin_rad) << said;
    EXPECT_NEAR(text::degrees(least_rad), std::stod(words[4]), 1.0) << said;
  }
  EXPECT_GT(by_phase, 0U);
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
