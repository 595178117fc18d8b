// SPDX-License-Identifier: MIT
#include <set>

#include "brief/sentences.hpp"
#include "briefs.hpp"
#include "hal/signal_pattern.hpp"
#include "test.hpp"

namespace fantail::brief {
namespace {

/// A brief of a plan; nothing is flown.
Brief of_plan(const std::vector<std::string>& changes) {
  Brief brief;
  brief.plan = scenario(changes).plan;
  return brief;
}

TEST(Sheet, HasThePatternsThatTheBoardShows) {
  const std::string page = page_html(of_plan({}), {});
  std::set<std::string> patterns;
  for (const SignalMeaning& one : signal_meanings()) {
    const hal::SignalPattern pattern = hal::pattern(one.signal);
    patterns.insert(std::string{pattern.light} + std::string{pattern.sound});
    EXPECT_NE(page.find("aria-label=\"" + std::string{pattern.light} + "\""), std::string::npos) << one.phase;
  }
  EXPECT_EQ(patterns.size(), signal_meanings().size()) << "each state has a pattern of its own";
}

TEST(Sheet, TheGateIsInWordsWithTheNumbersOfThePlan) {
  const auto first = [](const std::vector<std::string>& changes) { return gate_sentences(of_plan(changes)).front(); };
  EXPECT_EQ(first({}), "Canards stay at trim until the rocket is 2 m beyond the guide and faster than 17 m/s.");
  EXPECT_EQ(first({"guide.minimum_speed_m_s=0", "guide.clearance_m=1.5"}),
            "Canards stay at trim until the rocket is 1.5 m beyond the guide.");
  EXPECT_EQ(
      first({"dormancy.until=burn_out", "dormancy.burn_time_s=3"}),
      "Canards stay at trim until burn-out is detected (no thrust for 0.1 s, at least 3.3 s after first thrust).");
  EXPECT_EQ(first({"dormancy.until=max_dynamic_pressure and height", "dormancy.height_m=1500"}),
            "Canards stay at trim until the estimated dynamic pressure is 2 % below its maximum, and the estimated "
            "height, less its error, is above 1500 m.");
}

TEST(Sheet, WhatEndsControlHasTheFailedCanardAndTheAbortOnlyWhereThePlanHasThem) {
  const auto all = [](const std::vector<std::string>& changes) {
    std::string text;
    for (const std::string& sentence : end_sentences(of_plan(changes).plan)) {
      text += sentence;
    }
    return text;
  };
  EXPECT_NE(all({}).find("tilt over 60 deg from the vertical"), std::string::npos) << all({});
  EXPECT_EQ(all({}).find("abort"), std::string::npos) << all({});
  EXPECT_NE(all({}).find("A failed canard does not end control"), std::string::npos) << all({});
  const std::string strict =
      all({"run.canard_fault=end_control", "run.abort_input=open_aborts", "run.tilt_from=guide"});
  EXPECT_NE(strict.find("from the direction at rest on the guide"), std::string::npos) << strict;
  EXPECT_NE(strict.find("; a failed canard; abort."), std::string::npos) << strict;
}

TEST(Sheet, ABrokenAbortWireIsSaidForEitherSense) {
  EXPECT_NE(abort_sentence(core::AbortInput::none).find("None fitted"), std::string::npos);
  EXPECT_NE(abort_sentence(core::AbortInput::open_aborts).find("so does a broken wire"), std::string::npos);
  EXPECT_NE(abort_sentence(core::AbortInput::closed_aborts).find("A broken wire does not"), std::string::npos);
}

TEST(Sheet, SaysThatRulesWereNotCheckedOrWhichFailFirst) {
  Brief brief = of_plan({});
  EXPECT_NE(page_html(brief, {}).find("rules: not checked"), std::string::npos);
  brief.rules = Rules{.pack = "Our range",
                      .sentence = "1 of 3 clauses fails.",
                      .caution = "Check against the current document.",
                      .clauses = {{"A", "PASS"}, {"B", "FAIL"}, {"C", "PASS"}}};
  const std::string page = page_html(brief, {});
  EXPECT_NE(page.find("Our range: 2 PASS, 1 FAIL."), std::string::npos);
  EXPECT_NE(page.find("B FAIL \u00b7 A PASS \u00b7 C PASS"), std::string::npos);
  EXPECT_NE(page.find("Check against the current document."), std::string::npos);
}

}  // namespace
}  // namespace fantail::brief
