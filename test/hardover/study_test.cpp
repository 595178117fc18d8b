// SPDX-License-Identifier: MIT
#include "hardover/study.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::hardover {
namespace {

Study study(const std::vector<std::string>& changes, const Options& options) {
  std::vector<input::Override> overrides;
  for (const std::string& change : changes) {
    overrides.push_back(input::parse_override(change));
  }
  return fly(input::load_scenario("tasha3_launch2", overrides), options, [](std::size_t, std::size_t) {});
}

// Upright and without wind the rocket is the same to all sides, so that it does not matter which canard it is, but for
// what the roll angle is at that moment, which only says to which side it goes.
TEST(Hardover, WithoutWindItDoesNotMatterWhichOfTheFourItIs) {
  const Study found = study({}, {.step_s = 3.0, .coupler_m = 0.8, .threads = 2});
  ASSERT_EQ(found.effects.size() % 4, 0U);
  const std::size_t instants = found.effects.size() / 4;
  ASSERT_GE(instants, 3U);
  for (std::size_t i = 0; i < found.effects.size(); ++i) {
    const Effect& of = found.effects[i];
    const Effect& first = found.effects[i % instants];
    EXPECT_EQ(of.canard, i / instants);
    EXPECT_EQ(of.from_s, first.from_s);
    EXPECT_NEAR(of.side_force_n, first.side_force_n, 0.05 * first.side_force_n + 0.05) << i;
    EXPECT_NEAR(text::degrees(of.turned_rad), text::degrees(first.turned_rad), 2.0) << i;
  }
}

// At its stop of 25 degrees against three that stand at 9 at most: the sum across the axis is at most that of 25 + 9
// and 9 + 9 at right angles, and at least what is left when the opposite one stands at 9 the same way.
TEST(Hardover, TheSideForceIsThatOfTheDeflectionsThatTheStopAndThePlanLimitAllow) {
  const Study found = study({}, {.step_s = 2.0, .coupler_m = {}, .threads = 2});
  EXPECT_EQ(found.stop_rad, text::radians(25.0));
  for (const Effect& one : found.effects) {
    const double sum_deg = text::degrees(one.side_force_n / (one.pressure_pa * found.side_area_m2));
    EXPECT_GE(sum_deg, 25.0 - 9.0 - 0.5);
    EXPECT_LE(sum_deg, std::hypot(25.0 + 9.0, 9.0 + 9.0) + 0.5);
    EXPECT_EQ(one.moment_n_m, std::nullopt);
  }
}

TEST(Hardover, ACanardThatPushesToNoSideMovesNoApogee) {
  const Study found = study({"aerodynamics.canard_side_area_m2=0", "aerodynamics.canard_position_m=0.3"},
                            {.step_s = 4.0, .coupler_m = 0.8, .threads = 2});
  for (const Effect& one : found.effects) {
    EXPECT_EQ(one.side_force_n, 0.0);
    EXPECT_EQ(one.moment_n_m, 0.0);
    EXPECT_NEAR(one.away_m, 0.0, 1e-6);
    EXPECT_NEAR(one.apogee_m, found.sound_apogee_m, 1e-6);
  }
}

TEST(Hardover, TheBendingMomentIsTheForceTimesItsDistanceFromTheCoupler) {
  const Study found = study({}, {.step_s = 5.0, .coupler_m = 0.8, .threads = 2});
  for (const Effect& one : found.effects) {
    EXPECT_DOUBLE_EQ(one.moment_n_m.value(), one.side_force_n * (0.8 - found.position_m));
  }
  EXPECT_EQ(found.worst().moment_n_m.value(), found.worst().side_force_n * (0.8 - found.position_m));
}

TEST(Hardover, EarlyItTurnsTheWayMoreThanLate) {
  const Study found = study({}, {.step_s = 4.0, .coupler_m = {}, .threads = 2});
  const std::size_t instants = found.effects.size() / 4;
  EXPECT_GT(found.effects[0].away_m, 2.0 * found.effects[instants - 1].away_m);
  EXPECT_GT(found.effects[0].away_m, 1.0);
}

// A servo of 600 deg/s turns by 12 degrees in 20 ms and for the time of a frame more, and lift grows with the angle:
// less than that of a stop at 25 degrees, and the rocket is back on its way.
TEST(Hardover, CutPulsesTurnTheRocketByLittle) {
  const Study cut = study({}, {.failure = Failure::cut_pulses, .step_s = 2.0, .coupler_m = {}, .threads = 2});
  for (const Effect& one : cut.effects) {
    if (one.side_force_n > 0.0) {
      EXPECT_LE(text::degrees(one.side_force_n / (one.pressure_pa * cut.side_area_m2)), 600.0 * (cut_s + 0.01));
    }
    EXPECT_LT(one.away_m, 10.0) << one.from_s;
  }
  EXPECT_GT(cut.worst().side_force_n, 0.01);
}

TEST(Hardover, TheResultsDoNotDependOnTheNumberOfThreads) {
  const Options one{.step_s = 5.0, .coupler_m = 0.8, .threads = 1};
  const Options three{.step_s = 5.0, .coupler_m = 0.8, .threads = 3};
  EXPECT_EQ(study_json(study({}, one)), study_json(study({}, three)));
}

TEST(Hardover, AVehicleThatDoesNotSayWhatItsCanardsDoToTheSideIsRefused) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.geometry.reset();
  try {
    (void)fly(scenario, {}, [](std::size_t, std::size_t) {});
    FAIL() << "it flew";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find("canard_side_area_m2"), std::string::npos) << error.what();
  }
  scenario.surroundings = sim::Surroundings::tunnel;
  EXPECT_THROW((void)fly(scenario, {}, [](std::size_t, std::size_t) {}), text::Error);
  scenario.surroundings = sim::Surroundings::flight;
  scenario.vehicle.airframe.reset();
  EXPECT_THROW((void)fly(scenario, {}, [](std::size_t, std::size_t) {}), text::Error);
}

}  // namespace
}  // namespace fantail::hardover
