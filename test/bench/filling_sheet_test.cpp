// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "bench/cycle.hpp"
#include "bench/sheet.hpp"
#include "bench/watch.hpp"
#include "bench/zero.hpp"
#include "figures.hpp"
#include "json/value.hpp"
#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

// What the board reports stands on the sheet that is signed, and what keeps the rocket from being armed fails it.

struct Signed {
  Sheet sheet;
  std::string text;
  std::string html;
  json::Value json;
};

Signed signed_sheet(const std::optional<protocol::BoardReport>& board, const Bounds& bounds = six_degrees()) {
  const Exercise exercise = Exercise::limits(bounds);
  Heading heading;
  heading.board = board;
  const link::Recording recording = Bench{}.record(exercise);
  const Sheet sheet = examine(recording, exercise, {}, heading);
  return {sheet, sheet_text(sheet), sheet_html(sheet, recording, exercise), json::parse(sheet_json(sheet))};
}

TEST(BoardOnTheSheet, AHealthyBoardStandsOnPageTerminalAndJsonAndPasses) {
  const Signed all = signed_sheet(
      protocol::BoardReport{.plan = protocol::PlanSource::stored, .battery_mv = std::uint16_t{7'912}, .overruns = 2});
  EXPECT_TRUE(all.sheet.passed());
  const std::string board = "no fault; reset by power-on, battery 7.91 V, 2 control ticks missed";
  EXPECT_TRUE(says(all.text, "  board     " + board + "\n")) << all.text;
  EXPECT_TRUE(says(all.html, "<dt>Board</dt><dd>" + board + "</dd>"));
  EXPECT_TRUE(says(all.text, "The board reports no fault that forbids arming."));
  EXPECT_EQ(all.json["board_faults"], json::Value::array());
  EXPECT_EQ(all.json["battery_v"], 7.91);
  EXPECT_EQ(all.json["ticks_missed"], 2);
  EXPECT_EQ(all.json["plan_source"], "stored");
  EXPECT_EQ(all.json["flash_failed"], false);
}

// Each of the 25 alone, and 16 together: none of them is armed (docs/can.md).
TEST(BoardOnTheSheet, EveryFaultFailsItByItsName) {
  for (unsigned bit = 0; bit < 25; ++bit) {
    const Signed all = signed_sheet(protocol::BoardReport{.faults = 1U << bit});
    const std::string name = fault_names(1U << bit).at(0);
    EXPECT_EQ(all.sheet.judgement(), Judgement::fail) << name;
    EXPECT_TRUE(says(all.text, "The rocket cannot be armed: its board reported " + name + ".")) << all.text;
    EXPECT_TRUE(says(all.html, "The rocket cannot be armed: its board reported " + name + "."));
    EXPECT_EQ(all.json["judgement"], "fail");
    EXPECT_EQ(all.json["passed"], false);
    EXPECT_EQ(all.json["board_faults"], json::Value::array({name}));
  }
  EXPECT_EQ(signed_sheet(protocol::BoardReport{.faults = 0xFFFF}).sheet.judgement(), Judgement::fail);
}

TEST(BoardOnTheSheet, AFailedFlashAndAStoredPlanThatIsNotInForceFailItToo) {
  EXPECT_EQ(signed_sheet(protocol::BoardReport{.flash_failed = true}).sheet.judgement(), Judgement::fail);
  for (const auto& [plan, passes] : {std::pair{protocol::PlanSource::built_in, true},
                                     {protocol::PlanSource::stored, true},
                                     {protocol::PlanSource::stored_is_broken, false},
                                     {protocol::PlanSource::stored_is_newer, false},
                                     {protocol::PlanSource::flash_unreadable, false}}) {
    EXPECT_EQ(signed_sheet(protocol::BoardReport{.plan = plan}).sheet.passed(), passes) << static_cast<int>(plan);
  }
}

TEST(BoardOnTheSheet, WhatIsNotKnownOfTheBoardIsNotSaid) {
  const Signed all = signed_sheet(std::nullopt);
  EXPECT_TRUE(all.sheet.passed());
  EXPECT_FALSE(says(all.text, "board"));
  EXPECT_EQ(all.json["board_faults"], nullptr);
}

TEST(BoardOnTheSheet, AnEnduranceRunHasItToo) {
  Cycle cycle{.lap_s = 5.0, .planned_laps = 1};
  cycle.heading.board = protocol::BoardReport{.faults = 8};
  EXPECT_TRUE(says(cycle_text(cycle), "board     imu_silent (prevents arming); reset by power-on"))
      << cycle_text(cycle);
  EXPECT_EQ(json::parse(cycle_json(cycle))["board_faults"], json::Value::array({"imu_silent"}));
}

TEST(LittleTravel, ALimitCloseToTheTrimIsDoubtedAndNotJudged) {
  struct Case {
    double limit_deg;
    double trim_deg;
    bool judged;
  };
  for (const Case& one : {Case{0.3, 0.0, false}, Case{0.49, 0.0, false}, Case{0.5, 0.0, true}, Case{2.0, 1.6, false},
                          Case{2.0, -1.6, false}, Case{2.0, 1.5, true}, Case{6.0, 6.0, false}}) {
    const Signed all = signed_sheet(std::nullopt, six_degrees(one.limit_deg, one.trim_deg));
    EXPECT_EQ(all.sheet.doubts.empty(), one.judged) << one.limit_deg << " deg, trim " << one.trim_deg;
    if (!one.judged) {
      EXPECT_EQ(all.sheet.judgement(), Judgement::none);
      EXPECT_EQ(all.json["canards"][0]["cause"], "not_judged");
    }
  }
  const Signed all = signed_sheet(std::nullopt, six_degrees(0.3));
  EXPECT_TRUE(says(
      all.text,
      "Canard 1 has a limit of 0.30 deg and a trim of 0.00 deg; with less than 0.5 deg between them it is not judged."))
      << all.text;
  EXPECT_TRUE(says(all.text, "Send a plan with wider canard limits or smaller trims, and run again.")) << all.text;
}

TEST(LittleTravel, MeasuresNeitherCentreNorScale) {
  const Exercise exercise = Exercise::limits_of(six_degrees(0.3), 2);
  const ZeroReading reading = zero_reading(examine(Bench{}.record(exercise), exercise, {}, {}), 2);
  EXPECT_FALSE(reading.run);
  EXPECT_EQ(reading.refusal,
            "Canard 3 is not measured: its limit of 0.30 deg is less than 0.5 deg beyond its trim of 0.00 deg.");
}

bool holds(const std::string& html, const std::string& words) { return html.find(words) != std::string::npos; }

// A canard's heading and plots, up to the next canard.
std::string part_of(const std::string& html, int canard) {
  const std::size_t begin = html.find("<h2>Canard " + std::to_string(canard));
  const std::size_t end = html.find("<section", begin);
  return begin == std::string::npos ? std::string{} : html.substr(begin, end - begin);
}

class Filling : public testing::Test {
 protected:
  // What is shown after each turn.
  std::vector<std::string> show(Bench bench) {
    std::vector<std::string> shown;
    const link::Recording recording = bench.record(exercise);
    for (const link::Tick& tick : recording.ticks()) {
      if (auto html = sheet.take(tick)) {
        shown.push_back(*html);
      }
    }
    whole = sheet_inner_html(examine(recording, exercise, {}, {}), recording, exercise);
    return shown;
  }

  Exercise exercise = Exercise::limits(six_degrees());
  FillingSheet sheet{exercise, {}, {}};
  std::string whole;
};

Bench slipping_second() {
  Bench bench;
  bench.canards[1].gain = 0.6;
  return bench;
}

TEST_F(Filling, OnASlowPcTheTurnsThatAreOverAreShownAsTheWholeSheetShowsThem) {
  Bench bench = slipping_second();
  bench.pace = 0.73;
  const std::vector<std::string> shown = show(bench);
  ASSERT_EQ(shown.size(), 4U);
  for (std::size_t turns = 1; turns <= 4; ++turns) {
    for (int canard = 1; canard <= static_cast<int>(turns); ++canard) {
      const std::string part = part_of(shown[turns - 1], canard);
      EXPECT_EQ(part.substr(0, part.find("</h2>")),
                canard == 2 ? "<h2>Canard 2 slips" : part_of(whole, canard).substr(0, part.find("</h2>")));
      const std::size_t steps = part.find("10 to 90 % in ");
      EXPECT_TRUE(holds(part_of(whole, canard), part.substr(steps, part.find(" ms", steps) - steps)));
    }
    EXPECT_FALSE(holds(shown[turns - 1], "not judged"));
    EXPECT_EQ(holds(shown[turns - 1], "<b>Canard 2 slips:</b>"), turns >= 2);
    EXPECT_TRUE(part_of(shown[turns - 1], static_cast<int>(turns) + 1).empty()) << "it still moves";
  }
}

TEST_F(Filling, WhatHasBeenFoundStaysWhenTheVerdictIsInDoubt) {
  Bench bench = slipping_second();
  bench.lost_share = 0.04;
  const std::vector<std::string> shown = show(bench);
  ASSERT_EQ(shown.size(), 4U);
  EXPECT_TRUE(holds(shown[3], "<b>Canard 2 slips:</b>"));
  EXPECT_TRUE(holds(shown[3], "<b>So far there is no basis for a verdict:</b>"));
  EXPECT_TRUE(holds(whole, "NO VERDICT"));
}

TEST_F(Filling, AnExerciseThatIsGivenUpSaysWhyAndKeepsWhatItHasShown) {
  EXPECT_TRUE(holds(sheet.given_up("interrupted; the canards are centred"), "No sheet"));
  const link::Recording recording = slipping_second().record(exercise);
  for (const link::Tick& tick : recording.ticks().first(10'000)) {
    (void)sheet.take(tick);
  }
  const std::string html = sheet.given_up("interrupted; the canards are centred");
  EXPECT_TRUE(holds(html, "<h2>Ended early with 3 turns left</h2>"));
  EXPECT_TRUE(holds(html, "Interrupted; the canards are centred."));
  EXPECT_TRUE(holds(html, "<b>Canard 2 slips:</b>"));
  EXPECT_FALSE(holds(html, "to come"));
}

}  // namespace

}  // namespace fantail::bench
