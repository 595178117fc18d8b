// SPDX-License-Identifier: MIT
#include <set>

#include "brief/sentences.hpp"
#include "briefs.hpp"
#include "hal/signal_pattern.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

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
  EXPECT_EQ(first({}),
            "Canards are commanded to trim until the rocket is 2 m beyond the guide and faster than 17 m/s.");
  EXPECT_EQ(first({"guide.minimum_speed_m_s=0", "guide.clearance_m=1.5"}),
            "Canards are commanded to trim until the rocket is 1.5 m beyond the guide.");
  EXPECT_EQ(first({"dormancy.until=burn_out", "dormancy.burn_time_s=3"}),
            "Canards are commanded to trim until burn-out is detected (axial force below 0.15 g for 0.1 s, at least "
            "3.3 s after first thrust).");
  EXPECT_EQ(
      first({"dormancy.until=max_dynamic_pressure and height", "dormancy.height_m=1500"}),
      "Canards are commanded to trim until the estimated dynamic pressure is 2 % below its maximum, and the estimated "
      "height, less its error, is above 1500 m.");
}

TEST(Sheet, WhatEndsControlHasTheFailedCanardAndTheAbortOnlyWhereThePlanHasThem) {
  const auto all = [](const std::vector<std::string>& changes) {
    std::string text;
    for (const std::string& sentence : end_sentences(of_plan(changes))) {
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

TEST(Sheet, WhatEndedTheSimulatedControlIsSaid) {
  Brief brief = of_plan({});
  EXPECT_EQ(end_sentences(brief).back().find("Simulated"), std::string::npos) << "it went on to apogee";
  brief.nominal.control_end =
      ControlEnd{.time_s = 16.987, .before_apogee_s = 8.854, .why = "the rocket tilted too far"};
  EXPECT_EQ(end_sentences(brief).back(),
            "Simulated: control ends at 16.99 s, 8.85 s before apogee: the rocket tilted too far.");
}

// 359.7 deg rounds to 360, which is 0.
TEST(Sheet, ABearingIsSpelledInOneWay) {
  Brief brief = of_plan({});
  brief.is_six_dof = true;
  brief.wind_m_s = 4.0;
  brief.wind_from_rad = text::radians(360.0);
  brief.guide_tilt_rad = text::radians(6.0);
  brief.guide_azimuth_rad = text::radians(85.0);
  brief.landing = Landing{.has_parachute = true, .healthy_m = 100.0, .healthy_bearing_rad = text::radians(359.7)};
  EXPECT_EQ(wind_flown(brief), "4 m/s from 0 deg");
  EXPECT_EQ(lean(brief), "leans 6 deg towards 85 deg");
  EXPECT_EQ(landing_sentences(brief).front(), "Under the parachute: 100 m from the guide, bearing 0 deg.");
  const std::string text = text_of(brief);
  EXPECT_EQ(text.find("360"), std::string::npos) << text;
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
