// SPDX-License-Identifier: MIT
#include "tune/flights.hpp"

#include "input/scenario_file.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::tune {
namespace {

/// Under control for four seconds with a step of the reference after two; the roll is `off_rad` from it all the time.
flight::Flight made_flight(double off_rad, double noise_rad) {
  flight::Flight flight;
  for (int i = 0; i < 4000; ++i) {
    flight::Row row{.time_s = 1e-3 * i, .phase = core::Phase::controlling};
    row.reference_rad = i < 2000 ? 0.0 : 1.0;
    const bool just_stepped = i % 2000 < 1000;
    row.truth = flight::Truth{.roll_angle_rad = row.reference_rad + (just_stepped ? 3.0 : 1.0) * off_rad};
    row.command_rad = 1e-4 * i + (i % 2 == 0 ? noise_rad : -noise_rad);
    flight.rows.push_back(row);
  }
  return flight;
}

TEST(RollErrors, LeaveOutTheFirstSecondAndThatAfterAStep) {
  const RollErrors found = roll_errors(made_flight(-0.1, 0.0));
  EXPECT_NEAR(found.settled->mean_rad, 0.1, 1e-12);
  EXPECT_NEAR(found.settled->largest_rad, 0.1, 1e-12);
  EXPECT_NEAR(found.all->mean_rad, 0.2, 1e-12);
  EXPECT_NEAR(found.all->largest_rad, 0.3, 1e-12);
  EXPECT_FALSE(roll_errors({}).all);
}

// Alternating by n it has the standard deviation n; a ramp of 0.1 rad/s over a fifth of a second has 0.02 / sqrt(12).
TEST(CommandNoise, IsTheDeviationFromTheMeanOfAFifthOfASecond) {
  EXPECT_NEAR(*command_noise_rad(made_flight(0.0, 0.05)), std::hypot(0.05, 0.02 / std::sqrt(12.0)), 1e-4);
  EXPECT_FALSE(command_noise_rad({}));
}

TEST(FlyPairs, FliesTheSameRocketByBothPlansWhateverTheThreads) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const auto pairs = fly_pairs(scenario, scenario.plan, {.flights = 3, .threads = 1}, [](std::size_t) {});
  const auto again = fly_pairs(scenario, scenario.plan, {.flights = 3, .threads = 2}, [](std::size_t) {});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(compared(pairs[i].before)->mean_rad, compared(pairs[i].after)->mean_rad);
    EXPECT_EQ(compared(pairs[i].after)->mean_rad, compared(again[i].after)->mean_rad);
    EXPECT_GT(pairs[i].damping_m2, 23.0 / 1.5);
    EXPECT_LT(pairs[i].damping_m2, 23.0 * 1.5);
  }
  EXPECT_NE(pairs[0].torque_m, pairs[1].torque_m);
  EXPECT_EQ(sum(pairs, &Pair::before).flights, 3U);
  // The offset of 4.9 degrees over the gain of 0.5.
  EXPECT_NEAR(text::degrees(*sum(pairs, &Pair::before).mean_rad), 9.8, 0.5);
}

// It rests 9.8 degrees away by the old plan, and at its reference by one that rejects the offset.
TEST(FlyPairs, CountsARollThatIsSteadyFartherAwayThanIsAskedAsSteadyAndNotAsHeld) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.rest_limit_rad = text::radians(5.0);
  core::FlightPlan integral = scenario.plan;
  integral.offset.rejection = core::OffsetRejection::integral;
  integral.offset.integral_gain_per_s = 0.5F;
  integral.controller.derivative_gain_s = 0.08F;
  const auto pairs = fly_pairs(scenario, integral, {.flights = 2, .threads = 1}, [](std::size_t) {});
  const Sum before = sum(pairs, &Pair::before);
  EXPECT_EQ(before.held, 0U);
  EXPECT_EQ(before.off_command, 2U);
  EXPECT_EQ(before.steady, 2U);
  EXPECT_EQ(sum(pairs, &Pair::after).held, 2U);
}

}  // namespace
}  // namespace fantail::tune
