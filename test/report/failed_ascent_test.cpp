// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "report/answer.hpp"
#include "report/results.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

/// A roll that is held throughout, of a rocket that turned over.
flight::Flight turned_over() {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.burnout_s = 5.25;
  flight.before_burnout = {
      .turned_over_s = 3.0, .largest_tilt_rad = text::radians(165.4), .sank_s = 4.5, .sank_m = 3.1};
  flight.path = {{.time_s = 0.0}};
  return flight;
}

TEST(FailedAscentText, TellsTheTurnFirstAndTheRestInTheOrderOfTime) {
  flight::Flight flight = turned_over();
  flight.before_burnout->parachute_s = 4.6;
  flight.before_burnout->ground_s = 5.1;
  EXPECT_EQ(
      before_burnout(flight),
      "The rocket turned over while the motor burned: from 3.00 s on its nose pointed below the horizon, up to "
      "165 deg from upright. It sank by 3.1 m from 4.50 s on, before burn-out. It opened its parachute at 4.60 s, "
      "before burn-out. It came down at 5.10 s, before burn-out. Burn-out was at 5.25 s.");
}

TEST(FailedAscentText, IsTheVerdictWhateverTheRoll) {
  EXPECT_EQ(verdict_of(SyntheticFlight{}.flight).outcome, Outcome::held);
  const flight::Flight flight = turned_over();
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::ascent_failed);
  EXPECT_EQ(result::tone(summary(flight, figures(flight), v).verdict), page::Tone::bad);
  EXPECT_TRUE(v.text.starts_with("The rocket turned over while the motor burned: ")) << v.text;
  EXPECT_NE(v.text.find("oll stayed within "), std::string::npos) << v.text;
  EXPECT_NE(result::html(answer(flight, figures(flight), v)).find("Ascent failed"), std::string::npos);
}

TEST(FailedAscentText, AHopOnThePadIsToldAndDecidesNothing) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.before_burnout = {.ground_s = 0.05, .left_again_s = 0.15};
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_TRUE(
      v.text.starts_with("The rocket fell back on its pad at 0.05 s and left it again at 0.15 s; times count "
                         "from the first lift-off. "))
      << v.text;
}

TEST(FailedAscentText, IsReadBackFromTheSummary) {
  flight::Flight flight = turned_over();
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  const std::string json = result::json(summary(flight, f, v));
  EXPECT_EQ(json::parse(json)["outcome"], "ascent_failed");
  EXPECT_EQ(json::parse(json)["before_burnout"]["turned_over_s"], 3.0);
  const auto file = std::filesystem::temp_directory_path() / "fantail_failed_ascent_test.json";
  std::ofstream{file} << json;
  flight::Flight again = SyntheticFlight{}.flight;
  again.path = flight.path;
  add_summary(again, file);
  std::filesystem::remove(file);
  EXPECT_EQ(before_burnout(again), before_burnout(flight));
  EXPECT_EQ(verdict_of(again).outcome, Outcome::ascent_failed);
  EXPECT_FALSE(json::parse(result::json(summary(SyntheticFlight{}.flight, f, v))).contains("before_burnout"));
}

}  // namespace
}  // namespace fantail::report
