// SPDX-License-Identifier: MIT
#include "campaign/question.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/stop_rule.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

FlownRun run_with(std::string outcome, std::optional<double> hold_error_deg, std::optional<double> apogee_m = {}) {
  FlownRun run{.outcome = std::move(outcome)};
  run.figures.front() = hold_error_deg;
  run.figures[6] = apogee_m;
  return run;
}

std::string refusal(std::string_view text) {
  try {
    (void)parse_question(text);
  } catch (const text::Error& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(Question, OfAnOutcomeIsMetByThatOutcomeAlone) {
  const Question question = parse_question("outcome=cut_short");
  EXPECT_TRUE(question.is_met_by(run_with("cut_short", 3.0)));
  EXPECT_FALSE(question.is_met_by(run_with("held", 3.0)));
  EXPECT_EQ(question.text(), "outcome=cut_short");
}

TEST(Question, OfAFigureTakesItsBoundInAndARunWithoutItDoesNotMeetIt) {
  const Question at_least = parse_question("apogee_m>=900.5");
  EXPECT_TRUE(at_least.is_met_by(run_with("held", {}, 900.5)));
  EXPECT_FALSE(at_least.is_met_by(run_with("held", {}, std::nextafter(900.5, 0.0))));
  EXPECT_FALSE(at_least.is_met_by(run_with("held", {})));
  EXPECT_EQ(at_least.text(), "apogee_m>=900.5");
  EXPECT_EQ(at_least.words(), "Apogee at least 900.5 m");
  const Question at_most = parse_question("largest_hold_error_deg<=5");
  EXPECT_TRUE(at_most.is_met_by(run_with("not_held", 5.0)));
  EXPECT_FALSE(at_most.is_met_by(run_with("held", std::nextafter(5.0, 6.0))));
  EXPECT_FALSE(at_most.is_met_by(run_with("held", {})));
}

TEST(Question, SaysWhatIsAllowed) {
  EXPECT_NE(refusal("outcome=good").find("\"outcome=good\" is not a question; allowed: outcome=held, outcome=not_held"),
            std::string::npos)
      << refusal("outcome=good");
  EXPECT_NE(refusal("apogee>=3")
                .find("apogee_m, rest_error_deg, uncontrolled_time_before_apogee_s, gate_time_s, gate_height_m, "
                      "gate_rate_deg_s, gate_angle_deg, capture_time_s, top_mach, static_margin_calibres, "
                      "angle_of_attack_deg with >= or <= and a number"),
            std::string::npos);
  for (const char* text : {"", "apogee_m", "apogee_m=3", "apogee_m>3", "apogee_m>=", "apogee_m>=nan", "apogee_m>=3m"}) {
    EXPECT_NE(refusal(text).find("is not a question; allowed: "), std::string::npos) << text;
  }
}

TEST(Question, IsNotMetByARunWithAFigureThatIsNoNumber) {
  const Question high = parse_question("apogee_m>=50");
  EXPECT_TRUE(high.is_met_by(run_with("held", {}, 90.0)));
  EXPECT_FALSE(high.is_met_by(run_with("not_finite", {}, 90.0)));
}

std::vector<FlownRun> runs_held(std::size_t held, std::size_t of) {
  std::vector<FlownRun> flown(of, run_with("not_held", 20.0));
  std::fill_n(flown.begin(), held, run_with("held", 1.0));
  return flown;
}

// Of n runs that are all held the sequence's low bound is where (n + 1) s^n = 0.05: 0.9 from 72 runs on (0.9^72
// = 5.1e-4 and 73 times that 0.037; 0.9^64 times 65 is 0.077).
TEST(StopRule, StopsAfterTheChunkWithWhichItIsDecided) {
  const StopRule rule{.required = 0.9};
  EXPECT_EQ(stops_at(rule, runs_held(640, 640)), 128U);
  EXPECT_EQ(stops_at(rule, runs_held(0, 640)), 64U) << "all below as well";
  EXPECT_EQ(stops_at(rule, runs_held(576, 640)), 128U) << "the runs behind it do not count";
  EXPECT_EQ(stops_at(rule, runs_held(60, 60)), 60U) << "it never does";
}

TEST(StopRule, StopsWhenTheShareIsKnownAsCloselyAsAsked) {
  std::vector<FlownRun> flown;
  for (int i = 0; i < 6400; ++i) {
    flown.push_back(run_with(i % 2 == 0 ? "held" : "not_held", 1.0));
  }
  const std::size_t after = stops_at({.within = 0.05}, flown);
  const Bounds bounds = confidence_sequence(after / 2, after);
  EXPECT_LE(bounds.high - bounds.low, 0.1);
  const Bounds before = confidence_sequence(after / 2 - 32, after - 64);
  EXPECT_GT(before.high - before.low, 0.1);
}

}  // namespace
}  // namespace fantail::campaign
