// SPDX-License-Identifier: MIT

#include "fly/loop_margins.hpp"
#include "input/scenario_file.hpp"
#include "sim/roll_plant.hpp"
#include "stability/canard_sense.hpp"
#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::stability {
namespace {

using text::degrees;

// The first launch at its top speed, as published: alpha 7.5, beta 10, gains 1 and 0.1 s, in air of 1.2 kg/m3.
RollLoop launch1_at_97_m_s(double servo_lag_s, double delay_s) {
  const sim::RollPlant plant{
      .inertia_kg_m2 = 0.00361, .reference_area_m2 = 5.0265e-5, .damping_m2 = 7.5, .torque_m = 10};
  return {.proportional_gain = 1.0,
          .derivative_gain_s = 0.1,
          .damping_rate_per_s = plant.damping_rate_per_s(1.2, 97.0),
          .authority_per_s2 = plant.authority_per_s2(1.2, 97.0),
          .servo_lag_s = servo_lag_s,
          .delay_s = delay_s};
}

TEST(Oracle, Row29PhaseMarginsOfTheFirstLaunch) {
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.0, 0.0))->phase_margin_rad), 88, 3);
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.020, 0.0))->phase_margin_rad), 40, 3);
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.020, 0.015))->phase_margin_rad), -7, 3);
}

// Rate feedback alone around a plant without damping is an integrator: |L| = kd b / w, its phase -90 degrees - delay w.
TEST(Margins, OfAnIntegratorWithDelayAreThoseOfTheTextbook) {
  const RollLoop loop{.derivative_gain_s = 0.1, .authority_per_s2 = 300.0, .delay_s = 0.01};
  const auto found = margins(loop);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->crossover_rad_s, 30.0, 1e-9);
  EXPECT_NEAR(found->phase_margin_rad, 0.5 * std::numbers::pi - 0.3, 1e-9);
  ASSERT_TRUE(found->gain_margin);
  EXPECT_NEAR(*found->gain_margin, 0.5 * std::numbers::pi / 0.01 / 30.0, 1e-9);
}

// K / (s (s + a) (1 + lag s)): Routh's rule gives the largest K as a (1 + a lag) / lag.
TEST(Margins, GainMarginWithoutRateFeedbackAgreesWithRouth) {
  const RollLoop loop{
      .proportional_gain = 0.5, .damping_rate_per_s = 8.0, .authority_per_s2 = 100.0, .servo_lag_s = 0.02};
  EXPECT_NEAR(*margins(loop)->gain_margin, 8.0 * (1.0 + 8.0 * 0.02) / 0.02 / 50.0, 1e-9);
}

TEST(Margins, AtTheGainMarginThePhaseMarginIsNought) {
  RollLoop loop = launch1_at_97_m_s(0.020, 0.005);
  const double factor = *margins(loop)->gain_margin;
  EXPECT_GT(factor, 1.0);
  loop.proportional_gain *= factor;
  loop.derivative_gain_s *= factor;
  EXPECT_NEAR(margins(loop)->phase_margin_rad, 0.0, 1e-9);
  EXPECT_NEAR(*margins(loop)->gain_margin, 1.0, 1e-9);
}

TEST(Margins, NoGainMakesALoopWithoutLagAndDelaySwing) {
  EXPECT_FALSE(margins(launch1_at_97_m_s(0.0, 0.0))->gain_margin);
}

TEST(Margins, ALoopWhoseGainNeverReachesOneHasNone) {
  EXPECT_FALSE(margins({.damping_rate_per_s = 5.0, .authority_per_s2 = 100.0, .servo_lag_s = 0.02}));
  EXPECT_FALSE(margins({.proportional_gain = 1.0, .damping_rate_per_s = 5.0, .authority_per_s2 = 0.0}));
  // kd b / (s + a) is largest at frequency zero.
  EXPECT_FALSE(margins({.derivative_gain_s = 0.01, .damping_rate_per_s = 5.0, .authority_per_s2 = 400.0}));
  EXPECT_TRUE(margins({.derivative_gain_s = 0.01, .damping_rate_per_s = 5.0, .authority_per_s2 = 600.0}));
}

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
  const std::string rest = ", and the others hardly outweigh that, or not at all";
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
  EXPECT_EQ(why_uncontrollable(scenario), "the canards hardly follow the roll command, or not at all");
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
