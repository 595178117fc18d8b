// SPDX-License-Identifier: MIT
#include "tune/tuning.hpp"

#include <filesystem>
#include <fstream>

#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "tune/alternatives.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

/// The last three of a sentence: of how many flights, the new plan's and the old one's.
Numbers last_three(const std::string& sentence) {
  const Numbers all = figures(sentence);
  return {all.end() - std::min<std::ptrdiff_t>(3, std::ssize(all)), all.end()};
}

void unwatched(Stage /*stage*/, std::size_t /*done*/) {}

const Tuning& second_launch() {
  static const Tuning tuning = tune(input::load_scenario("tasha3_launch2", {}),
                                    {.flights = 6, .command = "fantail tune tasha3_launch2"}, unwatched);
  return tuning;
}

TEST(Tuning, OfTheSecondLaunchIsBetterThanThePublishedPlan) {
  const Tuning& t = second_launch();
  ASSERT_TRUE(t.is_proposed()) << t.why_none;
  EXPECT_TRUE(t.is_better());
  EXPECT_LT(text::degrees(*t.flown_after().mean_rad), 3.0);
  EXPECT_GT(text::degrees(*t.flown_before().mean_rad), 9.0);
  EXPECT_GE(text::degrees(t.after->least.phase_margin_rad), 45.0);
  EXPECT_LE(t.after->settling_s.value(), 1.0);
}

TEST(Tuning, ItsPlanReadsBackBitForBit) {
  const Tuning& t = second_launch();
  const std::string file = testing::TempDir() + "tuned.toml";
  std::ofstream{file} << plan_text(t);
  const core::FlightPlan read = input::read_plan(input::Document::load(file));
  for (const core::PlanField& field : core::flight_plan_fields()) {
    for (std::size_t slot = 0; slot < field.used_slots(read); ++slot) {
      EXPECT_EQ(field.get_bits(read, slot), field.get_bits(t.after->plan, slot)) << field.section << '.' << field.key;
    }
  }
  std::filesystem::remove(file);
}

TEST(Tuning, IsTheSameInTextJsonAndPage) {
  const Tuning& t = second_launch();
  const json::Value said = json::parse(result::json(answer(t, "x.toml", {})));
  EXPECT_EQ(said["proposed"], true);
  EXPECT_EQ(said["plan"], "x.toml");
  EXPECT_EQ(said["flights"].size(), 6U);
  EXPECT_NE(result::text(answer(t, "", {})).find(flights_sentence(t)), std::string::npos);
  EXPECT_NE(answer(t, "x.toml", {}).verdict.sentence.find(flights_sentence(t)), std::string::npos);
}

TEST(Tuning, SaysOfWhichFlightsTheNewPlanHasFewer) {
  Tuning t = second_launch();
  for (Pair& pair : t.pairs) {
    pair.before.outcome = report::Outcome::off_command;
    pair.after.outcome = report::Outcome::not_held;
  }
  t.pairs.front().after.outcome = report::Outcome::off_command;
  EXPECT_FALSE(t.is_proposed());
  EXPECT_EQ(last_three(flights_sentence(t)), (Numbers{"6", "1", "6"})) << "steady ones: " << flights_sentence(t);
  for (Pair& pair : t.pairs) {
    pair.after.outcome = report::Outcome::off_command;
  }
  EXPECT_TRUE(t.is_proposed());
  t.pairs.front().before.outcome = report::Outcome::held;
  EXPECT_FALSE(t.is_proposed());
  EXPECT_EQ(last_three(flights_sentence(t)), (Numbers{"6", "0", "1"})) << "held ones: " << flights_sentence(t);
}

// 7.3 degrees of offset, and a limit of 6.
TEST(Tuning, OfTheFirstLaunchSaysThatNoGainsCanDoIt) {
  const Tuning t = tune(input::load_scenario("tasha3_launch1", {}), {.flights = 2}, unwatched);
  EXPECT_FALSE(t.is_proposed());
  EXPECT_NE(t.why_none.find("offset"), std::string::npos) << t.why_none;
  EXPECT_EQ(figures(t.why_none).at(0), "-7.3");
  EXPECT_EQ(figures(t.why_none).at(1), "6");
  EXPECT_EQ(json::parse(result::json(answer(t, "", {})))["plan"].is_null(), true);
}

TEST(Tuning, SaysWhatTheShortestSettlingTimeIs) {
  const Tuning t =
      tune(input::load_scenario("tunnel_steps", {}), {.settling_s = 0.1, .spread = 1.0, .flights = 1}, unwatched);
  EXPECT_FALSE(t.is_proposed());
  EXPECT_NE(t.why_none.find("0.1 s"), std::string::npos) << t.why_none;
  EXPECT_NE(t.why_none.find("integral"), std::string::npos) << t.why_none;
}

// A dead end: no gains, no other kind of law that is better, and not a word on what to do.
TEST(Tuning, WithoutGainsOrAnythingBetterSaysWhatToDoNext) {
  Tuning t;
  t.reach_rad = 0.1;
  t.why_none = "No such gains were found.";
  t.request.spread = 2.0;
  EXPECT_NE(next_step(t).find("tunnel"), std::string::npos) << next_step(t);
  EXPECT_NE(result::text(answer(t, "", {})).find(next_step(t)), std::string::npos);
  t.request.spread = 1.0;
  EXPECT_NE(next_step(t).find("--margin"), std::string::npos) << "no spread to make smaller: " << next_step(t);
  t.alternative = "--schedule gives gains of 0.5 and 0.05 s.";
  EXPECT_EQ(next_step(t), "");
  t.alternative.clear();
  t.largest_offset_rad = -0.2;
  EXPECT_EQ(next_step(t), "") << "why there are none says what would help";
}

// The nearest demands that the search found a law for, flown before they are named.
TEST(Tuning, NamesLowerDemandsOnlyWhereTheirLawLosesNoFlight) {
  Tuning t = second_launch();
  t.after.reset();
  t.within_reach = t.request;
  t.within_reach->settling_s = 1.9;
  t.within_reach->phase_margin_rad = text::radians(45.0);
  const Judged law = *second_launch().after;
  try_lower_demands(t, [&law](Tuning& other) { other.after = law; });
  const Numbers named = figures(t.alternative);
  ASSERT_GE(named.size(), 2U) << t.alternative;
  EXPECT_EQ(named[0], "45");
  EXPECT_EQ(named[1], "1.9");
  t.alternative.clear();
  try_lower_demands(t, [&law](Tuning& other) {
    other.after = law;
    other.pairs.front().before.outcome = report::Outcome::held;
    other.pairs.front().after.outcome = report::Outcome::not_held;
  });
  EXPECT_EQ(t.alternative, "");
  try_lower_demands(t, [](Tuning& other) { other.after.reset(); });
  EXPECT_EQ(t.alternative, "");
}

TEST(Tuning, OfCanardsThatTurnTheWrongWayIsRefused) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (core::CanardPlan& canard : scenario.plan.canards.each) {
    canard.direction = core::Direction::reversed;
  }
  try {
    (void)tune(scenario, {.flights = 1}, unwatched);
    ADD_FAILURE() << "was not refused";
  } catch (const text::Error& error) {
    EXPECT_STREQ(error.what(),
                 "tasha3_launch2: all canards turn the rocket against the roll command (direction differs "
                 "between plan and vehicle), so no gains can be tuned");
  }
}

TEST(Tuning, WithoutAirIsRefused) {
  EXPECT_THROW((void)tune(input::load_scenario("gimbal", {}), {}, unwatched), text::Error);
}

TEST(Tuning, OfARocketThatIsNotStableSaysSoFirst) {
  Tuning tuning;
  EXPECT_EQ(model_sentence(tuning), "");
  tuning.pairs.resize(2);
  tuning.pairs[1].after.extremes.static_margin_calibres = -5.0;
  EXPECT_EQ(figures(model_sentence(tuning)), Numbers{"-5.00"});
  EXPECT_NE(model_sentence(tuning).find("stable"), std::string::npos) << model_sentence(tuning);
}

}  // namespace
}  // namespace fantail::tune
