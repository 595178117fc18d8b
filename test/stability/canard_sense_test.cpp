// SPDX-License-Identifier: MIT
#include "stability/canard_sense.hpp"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"

namespace fantail::stability {
namespace {

sim::Scenario with_reversed(std::initializer_list<std::size_t> in_plan,
                            std::initializer_list<std::size_t> in_vehicle = {}) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (const std::size_t canard : in_plan) {
    scenario.plan.canards.each[canard].direction = core::Direction::reversed;
  }
  for (const std::size_t canard : in_vehicle) {
    scenario.vehicle.canards[canard].reversed = true;
  }
  return scenario;
}

// s^2 + (a - kd b) s - kp b has a positive root for any b kp above zero.
TEST(CanardSense, CanardsThatTurnTheRocketAgainstTheCommandAreNamed) {
  const std::string differs = " (direction differs between plan and vehicle)";
  const std::string rest = ", and the others outweigh that hardly or not at all";
  EXPECT_EQ(why_uncontrollable(with_reversed({0, 1, 2, 3})),
            "all canards turn the rocket against the roll command" + differs);
  EXPECT_EQ(why_uncontrollable(with_reversed({}, {0, 1, 3})),
            "canards 1, 2 and 4 turn the rocket against the roll command" + rest + differs);
  EXPECT_EQ(why_uncontrollable(with_reversed({1}, {2})),
            "canards 2 and 3 turn the rocket against the roll command" + rest + differs)
      << "there the four cancel";
}

TEST(CanardSense, OneOfFourIsOutweighedAndTwoReversalsAreNone) {
  EXPECT_EQ(why_uncontrollable(with_reversed({})), "");
  EXPECT_EQ(why_uncontrollable(with_reversed({2})), "");
  EXPECT_EQ(why_uncontrollable(with_reversed({0, 1, 2, 3}, {0, 1, 2, 3})), "");
  EXPECT_EQ(left_in_the_end(with_reversed({0, 1, 2, 3}, {0, 1, 2, 3})), 1.0);
  EXPECT_EQ(works_against(with_reversed({0, 1, 2, 3}, {0, 1, 2, 3})), "");
  EXPECT_EQ(left_in_the_end(with_reversed({2})), 0.5);
  EXPECT_TRUE(works_against(with_reversed({2})).starts_with("canard 3 turns the rocket against"));
  EXPECT_EQ(left_in_the_end(with_reversed({0, 1, 2, 3})), -1.0);
}

TEST(CanardSense, AServoThatAFaultHasTurnedIsNotBlamedOnPlanAndVehicle) {
  sim::Scenario scenario = with_reversed({});
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    scenario.faults.push_back(
        {.device = sim::Device::servo, .canard = canard, .how = sim::GearFault{sim::ServoFault::reversed}});
  }
  EXPECT_EQ(why_uncontrollable(scenario), "all canards turn the rocket against the roll command");
  for (sim::Fault& fault : scenario.faults) {
    fault.how = sim::GearFault{sim::ServoFault::dead};
  }
  EXPECT_EQ(why_uncontrollable(scenario), "the canards follow the roll command hardly or not at all");
  scenario.faults.resize(2);
  scenario.plan.canards.each[3].direction = core::Direction::reversed;
  scenario.plan.run.canard_fault = core::CanardFaultPolicy::share;
  EXPECT_EQ(why_uncontrollable(scenario), "") << "the avionics may give the work to others";
}

TEST(CanardSense, FinsThatTakeAllOfTheTorqueBackAreNamed) {
  sim::Scenario scenario = with_reversed({});
  scenario.vehicle.canard_air.wash = 0.9;
  EXPECT_EQ(why_uncontrollable(scenario), "");
  scenario.vehicle.canard_air.wash = 1.0;
  EXPECT_EQ(why_uncontrollable(scenario), "the fins take back all of the canards' roll torque, or more");
}

}  // namespace
}  // namespace fantail::stability
