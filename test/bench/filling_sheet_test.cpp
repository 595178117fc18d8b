// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "bench/sheet.hpp"
#include "synthetic.hpp"

namespace fantail::bench {
namespace {

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
  EXPECT_TRUE(holds(shown[3], "<b>As it stands there will be no verdict:</b>"));
  EXPECT_TRUE(holds(whole, "NO VERDICT"));
}

TEST_F(Filling, AnExerciseThatIsGivenUpSaysWhyAndKeepsWhatItHasShown) {
  EXPECT_TRUE(holds(sheet.given_up("interrupted; the canards are centred"), "No sheet"));
  const link::Recording recording = slipping_second().record(exercise);
  for (const link::Tick& tick : recording.ticks().first(10'000)) {
    (void)sheet.take(tick);
  }
  const std::string html = sheet.given_up("interrupted; the canards are centred");
  EXPECT_TRUE(holds(html, "<h2>Given up with 3 more turns to do</h2>"));
  EXPECT_TRUE(holds(html, "Interrupted; the canards are centred."));
  EXPECT_TRUE(holds(html, "<b>Canard 2 slips:</b>"));
  EXPECT_FALSE(holds(html, "to come"));
}

}  // namespace
}  // namespace fantail::bench
