// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "flight/phase_names.hpp"
#include "json/value.hpp"
#include "page/page.hpp"
#include "report/answer.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

std::string page_of(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return result::html(answer(flight, f, verdict(flight, f)));
}

// What a reader without scripts gets.
std::string without_scripts(const std::string& page) { return page.substr(0, page.find("<script")); }

json::Value plot_data_of(const std::string& page) {
  const std::string tag = "id=\"live-data\">";
  const std::size_t begin = page.find(tag) + tag.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Html, LoadsNothingFromAnywhere) {
  const std::string page = page_of(SyntheticFlight{}.flight);
  for (const char* const word : {"src=", "@import", "<link", "url(", "href", "fetch(", "XMLHttpRequest"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
}

TEST(Html, CarriesTheLicenceOfThePlotLibrary) {
  EXPECT_NE(page_of(SyntheticFlight{}.flight).find("Permission is hereby granted"), std::string::npos);
}

TEST(Html, SaysVerdictFiguresEventsAndPhasesWithoutScripts) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(2.1); });
  const std::string text = without_scripts(page_of(synthetic.flight));
  EXPECT_NE(text.find(verdict_of(synthetic.flight).text), std::string::npos);
  EXPECT_NE(text.find("<dt>authority margin</dt><dd>4.0"), std::string::npos);
  EXPECT_NE(text.find("<td>launch detected</td>"), std::string::npos);
  EXPECT_NE(text.find(flight::display_name(core::PhaseReason::guide_clear)), std::string::npos);
  EXPECT_NE(text.find("<svg"), std::string::npos);
}

TEST(Html, SaysWhereTheLawOfThePlanComesToRestAndDrawsItsEstimate) {
  SyntheticFlight synthetic;
  const std::string published = page_of(synthetic.flight);
  EXPECT_NE(published.find("settles at R + u_d/kp: R is its reference, u_d the fin offset."), std::string::npos);
  EXPECT_NE(published.find("proportional-derivative"), std::string::npos);
  EXPECT_NE(published.find("True disturbance"), std::string::npos);
  synthetic.flight.plan.offset.rejection = core::OffsetRejection::integral;
  const std::string rejecting = page_of(synthetic.flight);
  EXPECT_EQ(rejecting.find("u_d/kp"), std::string::npos);
  EXPECT_NE(rejecting.find("settles at R, its reference."), std::string::npos);
  EXPECT_NE(rejecting.find("the reference R"), std::string::npos);
  EXPECT_NE(rejecting.find("and the law's estimate of it"), std::string::npos);
  synthetic.flight.why_uncontrollable = "all canards turn the rocket against the roll command";
  EXPECT_EQ(page_of(synthetic.flight).find("settles at R"), std::string::npos);
}

TEST(Html, SaysWhereItSettlesWithTheNumbersOfTheFlight) {
  SyntheticFlight synthetic;
  const auto here = [&synthetic] {
    const std::string page = page_of(synthetic.flight);
    const std::size_t begin = page.find("Here ", page.find("settles at R"));
    std::string said = page.substr(begin, page.find("</p>", begin) - begin);
    for (const auto& [in_html, plain] : {std::pair<std::string, const char*>{"\u2212", "-"}, {"&#39;", "'"}}) {
      while (said.find(in_html) != std::string::npos) {
        said.replace(said.find(in_html), in_html.size(), plain);
      }
    }
    return fantail::figures(said);
  };
  EXPECT_EQ(here(), (Numbers{"-5", "0.5", "-5", "0.5", "-10"}));
  synthetic.flight.left_by_fins = 0.8;  // -5 deg / (0.5 * 0.8)
  EXPECT_EQ(here(), (Numbers{"-12.5", "-5", "0.5", "0.8"}));
  synthetic.flight.left_by_fins = 1.0;
  synthetic.each_controlled(
      [](flight::Row& row) { row.truth->disturbance_rad = text::radians(row.time_s < 2.0 ? -5.0 : -4.0); });
  EXPECT_EQ(here(), (Numbers{"-10", "-8"}));
}

TEST(Html, OfARollThatIsNotJudgedNoHoldErrorAndNoSettlePointIsTold) {
  SyntheticFlight synthetic;
  synthetic.flight.airframe = flight::FlownAirframe{};  // no loop margin: its canards do not turn it
  const std::string page = without_scripts(page_of(synthetic.flight));
  EXPECT_NE(page.find("Not judged"), std::string::npos);
  for (const char* part : {"It settles at", "hold error", "than the fins need"}) {
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  }
}

TEST(Html, SaysWhichSpeedItShows) {
  SyntheticFlight synthetic;
  EXPECT_NE(page_of(synthetic.flight).find("<dt>top speed through the air</dt>"), std::string::npos);
  flight::Flight log = synthetic.flight;
  log.seed.reset();
  for (flight::Row& row : log.rows) {
    row.truth.reset();
  }
  EXPECT_NE(page_of(log).find("<dt>top speed by the log</dt>"), std::string::npos);
  synthetic.flight.path = {{.time_s = 0.0}, {.time_s = 4.0, .north_m = 30.0, .height_m = 400.0}};
  const std::string page = page_of(synthetic.flight);
  EXPECT_NE(page.find("<dt>top speed over ground</dt>"), std::string::npos);
  EXPECT_NE(page.find("true, through the air along the axis"), std::string::npos);
  EXPECT_NE(page.find("estimate, over ground along the guide"), std::string::npos);
  synthetic.flight.tunnel = true;
  EXPECT_NE(page_of(synthetic.flight).find("<dt>largest air speed</dt>"), std::string::npos);
}

TEST(Html, NoLineIsDrawnWhereRowsAreMissing) {
  SyntheticFlight synthetic;
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s > 2.0 && row.time_s < 2.5; });
  const json::Value data = plot_data_of(page_of(synthetic.flight));
  for (const json::Value& plot : data["plots"]) {
    const auto& times = plot["milliseconds"];
    const auto between =
        std::ranges::find_if(times, [](const json::Value& t) { return t.number() > 2000 && t.number() < 2500; });
    ASSERT_NE(between, times.end()) << plot["title"];
    for (const json::Value& series : plot["series"]) {
      EXPECT_TRUE(series["hundredths"][static_cast<std::size_t>(between - times.begin())].is_null()) << plot["title"];
    }
  }
}

TEST(Html, OfAFlightThatWasNotSimulatedNoSeedIsShown) {
  SyntheticFlight synthetic;
  synthetic.flight.seed.reset();
  synthetic.flight.notes = {"The recording was cut off."};
  const std::string text = without_scripts(page_of(synthetic.flight));
  EXPECT_EQ(text.find("seed"), std::string::npos);
  EXPECT_NE(text.find("About the log"), std::string::npos);
}

TEST(Html, ListsEventsInTheOrderInWhichTheyHappened) {
  SyntheticFlight synthetic;
  synthetic.flight.events.guide_clear_s = 0.15;  // off a short guide before the launch is detected
  synthetic.flight.events.control_end_s = 3.0;
  synthetic.flight.events.burnout_s = 3.2;
  synthetic.flight.events.apogee_s = 4.4;
  const std::string text = without_scripts(page_of(synthetic.flight));
  std::size_t last = 0;
  for (const char* event :
       {"lift-off", "off the guide", "launch detected", "control starts", "control ends", "burn-out", "apogee"}) {
    const std::size_t at = text.find("<td>" + std::string{event} + "</td>");
    ASSERT_NE(at, std::string::npos) << event;
    EXPECT_GT(at, last) << event;
    last = at;
  }
}

TEST(Html, APhaseThatTheFirstRowShowsBeganBeforeIt) {
  SyntheticFlight synthetic;
  const auto armed_row = [&synthetic] {
    const std::string text = without_scripts(page_of(synthetic.flight));
    const std::size_t begin = text.find("<td>Armed</td>");
    return text.substr(begin, text.find("</tr>", begin) - begin);
  };
  const std::string_view reason = flight::display_name(core::PhaseReason::armed_by_switch_and_command);
  EXPECT_NE(armed_row().find("log begins"), std::string::npos) << armed_row();
  EXPECT_NE(armed_row().find(reason), std::string::npos) << armed_row();
  synthetic.flight.phase_changes.front().time_s = -0.25;
  EXPECT_EQ(armed_row().find("log begins"), std::string::npos) << armed_row();
  EXPECT_NE(armed_row().find(reason), std::string::npos);
}

TEST(Html, ListsWhatWasAssumedAndCallsAnImposedRollImposed) {
  SyntheticFlight synthetic;
  for (const char* none : {"no imposed roll", "no faults"}) {
    EXPECT_NE(without_scripts(page_of(synthetic.flight)).find(none), std::string::npos) << none;
  }
  synthetic.flight.notes = {"Canard 3 is stuck from 2 s on."};
  synthetic.flight.imposed_roll = flight::ImposedRoll{0.21, text::radians(-0.6), text::radians(51.8)};
  const std::string text = without_scripts(page_of(synthetic.flight));
  EXPECT_EQ(text.find("no imposed roll"), std::string::npos);
  for (const char* imposed : {"imposed", "0.21 s", "\u22120.6 deg", "51.8 deg/s"}) {
    EXPECT_NE(text.find(imposed), std::string::npos) << imposed;
  }
  EXPECT_NE(text.find("<li>Canard 3 is stuck from 2 s on.</li>"), std::string::npos);
}

TEST(Html, WritesNegativeNumbersInSentencesWithTheMinusOfItsFigures) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->disturbance_rad = text::radians(-12.0);
    row.saturated = true;
    row.command_rad = text::radians(-9.0);
  });
  const std::string text = without_scripts(page_of(synthetic.flight));
  EXPECT_NE(text.find("(\u22129 deg)"), std::string::npos) << text.substr(0, text.find("<dl"));
  EXPECT_NE(text.find(" 3.0 deg less than the fins need"), std::string::npos);
}

TEST(Html, APathInAPlaneIsShownWithoutDirections) {
  SyntheticFlight synthetic;
  synthetic.flight.path_frame = flight::PathFrame::plane;
  synthetic.flight.path = {{.time_s = 0.0}, {.time_s = 4.0, .north_m = 30.0, .height_m = 400.0, .tilt_rad = 0.1}};
  synthetic.flight.events.apogee_s = 4.2;
  const std::string page = without_scripts(page_of(synthetic.flight));
  EXPECT_NE(page.find("distance across / m"), std::string::npos);
  EXPECT_NE(page.find("Tilt of the long axis"), std::string::npos);
  EXPECT_NE(page.find("drift at apogee"), std::string::npos);
  for (const char* unknown : {"towards", "east / m", "angle of attack"}) {
    EXPECT_EQ(page.find(unknown), std::string::npos) << unknown;
  }
}

TEST(Html, AHeldRocketIsShownAboutAllThreeAxes) {
  SyntheticFlight synthetic;
  EXPECT_EQ(page_of(synthetic.flight).find("All three axes"), std::string::npos);
  synthetic.flight.turning = {{.time_s = -1.0, .true_tilt_rad = 1.0},
                              {.time_s = 0.0, .true_tilt_rad = 0.0},
                              {.time_s = 1.0, .true_tilt_rad = text::radians(30.0), .tilt_rad = text::radians(29.5)}};
  const std::string page = without_scripts(page_of(synthetic.flight));
  for (const char* shown :
       {"Roll rate, about the long axis", "Pitch rate, about y", "Yaw rate, about z",
        "Tilt of the long axis from the vertical", "From control start on", "up to 30.0 deg", "by at most 0.50 deg"}) {
    EXPECT_NE(page.find(shown), std::string::npos) << shown;
  }
}

TEST(Html, TextFromFilesStaysText) {
  SyntheticFlight synthetic;
  const std::string attack = "</script><script>alert('1')</script>\"&";
  synthetic.flight.scenario = synthetic.flight.vehicle = synthetic.flight.plan_name = synthetic.flight.version = attack;
  synthetic.flight.notes = {attack};
  const std::string page = page_of(synthetic.flight);
  EXPECT_EQ(page.find("alert('1')"), std::string::npos);
  EXPECT_NE(page.find("&lt;/script&gt;&lt;script&gt;alert(&#39;1&#39;)"), std::string::npos);
}

TEST(Html, NoTextCanCloseTheDataScript) {
  EXPECT_EQ(page::escape_script_json(R"({"a":"</script><!--"})"), R"({"a":"\u003c/script>\u003c!--"})");
}

TEST(Html, PlotDataKeepsAPeakOfOneMillisecondAndTheLimits) {
  SyntheticFlight synthetic;
  for (int tick = 0; tick < 40'000; ++tick) {  // so long that most samples must go
    synthetic.flight.rows.push_back(synthetic.flight.rows.back());
    synthetic.flight.rows.back().time_s += 0.001;
  }
  synthetic.flight.rows[23'456].roll_rate_rad_s = text::radians(777.77);
  const std::string page = page_of(synthetic.flight);
  EXPECT_LT(page.size(), 1'500'000U);
  const auto data = plot_data_of(page);
  const auto& limits = data["plots"][2]["levels"];  // each above and below zero
  ASSERT_EQ(limits.size(), 6U);
  EXPECT_EQ(limits[0]["label"], "plan limit 9 deg");
  EXPECT_EQ(limits[0]["value"], 9.0);
  EXPECT_EQ(limits[5]["value"], -20.0);
  bool found = false;
  for (const auto& plot : data["plots"]) {
    ASSERT_EQ(plot["milliseconds"].size(), plot["series"][0]["hundredths"].size());
    if (plot["title"] == "Roll rate") {
      EXPECT_LT(plot["milliseconds"].size(), 20'000U);
      for (std::size_t i = 0; i < plot["milliseconds"].size(); ++i) {
        found = found || (plot["series"][1]["hundredths"][i] == 77'777 && plot["milliseconds"][i] == 22'956);
      }
    }
  }
  EXPECT_TRUE(found);
}

TEST(Html, AFlightWithoutARowStillMakesAPage) {
  const std::string page = page_of(flight::Flight{});
  EXPECT_NE(page.find("never armed"), std::string::npos);
  EXPECT_EQ(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(OverviewSvg, IsCompleteInItselfAndHasNoNumberThatIsNone) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    if (row.time_s > 3.0) {
      row.truth.reset();
    }
  });
  const std::string figure = page::live_figure(charts(synthetic.flight), "");
  const std::string svg = figure.substr(figure.find("<svg"), figure.find("</figure>") - figure.find("<svg"));
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>"));
  EXPECT_NE(svg.find("xmlns=\"http://www.w3.org/2000/svg\""), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find(">lift-off</text>"), std::string::npos);
  EXPECT_NE(svg.find(">Controlling</text>"), std::string::npos);
  EXPECT_NE(svg.find("class=\"stripe measured\""), std::string::npos);
}

}  // namespace
}  // namespace fantail::report
