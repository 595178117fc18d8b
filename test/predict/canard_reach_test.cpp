// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "predict/margins.hpp"
#include "predict/run.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::radians;

/// The figures of the text, and that it names what ends the canards.
void expect_reach(const CanardReach& reach, const std::vector<std::string>& found,
                  const std::vector<const char*>& ends) {
  EXPECT_EQ(figures(reach.text()), found);
  EXPECT_EQ(reach.set_by.empty(), ends.empty()) << reach.set_by;
  for (const char* end : ends) {
    EXPECT_NE(reach.text().find(end), std::string::npos) << reach.text();
  }
}

TEST(CanardReach, IsWhatAllCanardsReachAndNamesWhatEndsThem) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const double offset_rad = radians(4.9);
  EXPECT_NEAR(degrees(canard_reach(scenario, offset_rad).angle_rad), 9.0, 1e-5);
  expect_reach(canard_reach(scenario, offset_rad), {"9"}, {});
  EXPECT_NEAR(degrees(farthest_reach(scenario, offset_rad).angle_rad), 20.0, 1e-5);

  scenario.vehicle.servo.stop_rad = radians(8.0);
  EXPECT_NEAR(degrees(canard_reach(scenario, offset_rad).angle_rad), 8.0, 1e-12);
  expect_reach(canard_reach(scenario, offset_rad), {"8"}, {"servo"});

  scenario.plan.canards.each[1].mechanical_stop = core::Angle::from_degrees(7.0F);
  EXPECT_NEAR(degrees(canard_reach(scenario, offset_rad).angle_rad), 0.25 * (3.0 * 8.0 + 7.0), 1e-5);
  expect_reach(canard_reach(scenario, offset_rad), {"7.7", "2"}, {"canard 2", "plan"});
  EXPECT_NEAR(degrees(farthest_reach(scenario, offset_rad).angle_rad), 0.25 * (3.0 * 8.0 + 7.0), 1e-5);

  scenario.plan.controller.canard_limit = core::Angle::from_degrees(30.0F);
  scenario.plan.canards.each[1].mechanical_stop = core::Angle::from_degrees(25.0F);
  scenario.vehicle.servo.stop_rad = radians(25.0);
  EXPECT_EQ(canard_reach(scenario, offset_rad).set_by, "hard limit");

  scenario.plan.controller.canard_limit = core::Angle::from_degrees(9.0F);
  scenario.plan.canards.each[0].trim = core::Angle::from_degrees(2.0F);
  EXPECT_NEAR(degrees(canard_reach(scenario, offset_rad).angle_rad), 0.25 * (3.0 * 9.0 + 7.0), 1e-5);
  expect_reach(canard_reach(scenario, offset_rad), {"8.5"}, {"limit", "trim"});
  EXPECT_NEAR(degrees(canard_reach(scenario, -offset_rad).angle_rad), 9.0, 1e-5) << "of the other sense";
}

TEST(CanardReach, EndsWhereTheCanardsStall) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.canard_air.stall_rad = radians(12.0);
  expect_reach(canard_reach(scenario, radians(4.9)), {"9"}, {});
  expect_reach(farthest_reach(scenario, radians(4.9)), {"12"}, {"stall"});
  scenario.vehicle.canard_air.stall_rad = radians(7.0);
  expect_reach(canard_reach(scenario, radians(-4.9)), {"7"}, {"stall"});
}

TEST(CanardReach, IsWhatTheFinsLeaveOfIt) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.canard_air.wash = 0.5;
  expect_reach(canard_reach(scenario, radians(4.9)), {"4.5"}, {"wash"});
  scenario.vehicle.canard_air.stall_rad = radians(8.0);
  expect_reach(canard_reach(scenario, radians(4.9)), {"4"}, {"stall", "wash"});
  scenario.vehicle.canard_air.wash = 1.5;
  EXPECT_LT(canard_reach(scenario, radians(4.9)).angle_rad, 0.0);
}

TEST(CanardReach, IsThatOfTheCanardsThatWorkWhereTheScenarioBreaksSome) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (const std::size_t canard : {0U, 1U}) {
    scenario.faults.push_back(
        {.device = sim::Device::servo, .canard = canard, .how = sim::GearFault{sim::ServoFault::dead}});
  }
  EXPECT_NEAR(degrees(canard_reach(scenario, radians(-4.9)).angle_rad), 4.5, 1e-5);
  expect_reach(canard_reach(scenario, radians(-4.9)), {"4.5"}, {"faults"});
}

struct Mismatch {
  const char* name;
  void (*make)(sim::Scenario& scenario);
};

class CanardReachInFlight : public testing::TestWithParam<Mismatch> {};

// Against an offset that overpowers it the canards of a flight go as far as they can.
TEST_P(CanardReachInFlight, IsWhereTheTrueCanardsEnd) {
  for (const double offset_deg : {-18.0, 18.0}) {
    sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
    scenario.disturbance = {{.time_s = 0.0, .angle_rad = radians(offset_deg)}};
    scenario.plan.excitation.form = core::ExcitationForm::none;
    scenario.vehicle.servo.backlash_rad = 0.0;
    scenario.vehicle.imu.full_scale_rad_s = radians(20000.0);
    GetParam().make(scenario);
    const flight::Flight flight = fly::fly_scenario(scenario);
    const auto row = std::ranges::find_if(flight.rows, [](const flight::Row& each) { return each.time_s >= 3.0; });
    ASSERT_EQ(row->phase, core::Phase::controlling);
    ASSERT_TRUE(row->saturated);
    EXPECT_NEAR(degrees(canard_reach(scenario, radians(offset_deg)).angle_rad),
                degrees(row->truth->canard_rad) * (offset_deg > 0.0 ? -1.0 : 1.0), 0.02)
        << offset_deg;
  }
}

void breaks(sim::Scenario& scenario, sim::ServoFault fault, std::size_t canard, std::optional<double> angle_rad = {}) {
  scenario.faults.push_back({.device = sim::Device::servo, .canard = canard, .how = sim::GearFault{fault, angle_rad}});
}

INSTANTIATE_TEST_SUITE_P(
    Mismatches, CanardReachInFlight,
    testing::Values(
        Mismatch{"none", [](sim::Scenario&) {}},
        Mismatch{"servo_stop", [](sim::Scenario& s) { s.vehicle.servo.stop_rad = radians(4.0); }},
        Mismatch{"trim_of_the_plan_alone",
                 [](sim::Scenario& s) {
                   for (core::CanardPlan& canard : s.plan.canards.each) {
                     canard.trim = core::Angle::from_degrees(-3.0F);
                   }
                 }},
        Mismatch{"trim_of_the_rocket_alone", [](sim::Scenario& s) { s.vehicle.canards[1].trim_rad = radians(3.0); }},
        Mismatch{"two_dead",
                 [](sim::Scenario& s) {
                   breaks(s, sim::ServoFault::dead, 0);
                   breaks(s, sim::ServoFault::dead, 2);
                 }},
        Mismatch{"one_hard_over", [](sim::Scenario& s) { breaks(s, sim::ServoFault::hardover, 1); }},
        Mismatch{"one_stuck", [](sim::Scenario& s) { breaks(s, sim::ServoFault::stuck, 1, radians(2.0)); }},
        Mismatch{"one_reversed", [](sim::Scenario& s) { breaks(s, sim::ServoFault::reversed, 3); }},
        Mismatch{"one_off_its_trim", [](sim::Scenario& s) { breaks(s, sim::ServoFault::wrong_trim, 3); }},
        Mismatch{"one_slow", [](sim::Scenario& s) { breaks(s, sim::ServoFault::slow, 0); }},
        Mismatch{"stall", [](sim::Scenario& s) { s.vehicle.canard_air.stall_rad = radians(6.0); }},
        Mismatch{"wash",
                 [](sim::Scenario& s) {
                   s.vehicle.canard_air.wash = 0.4;
                   s.vehicle.canard_air.wash_distance_m = 1.0;
                 }},
        Mismatch{"reversed_by_the_fins", [](sim::Scenario& s) { s.vehicle.canard_air.wash = 1.2; }},
        Mismatch{"another_pulse_scale", [](sim::Scenario& s) { s.vehicle.servo.pulse_per_degree_us = 9.0; }}),
    [](const auto& each) { return std::string{each.param.name}; });

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
