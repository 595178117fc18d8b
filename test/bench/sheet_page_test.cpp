// SPDX-License-Identifier: MIT
// The sheet as a page, whole and while it fills.

#include "bench/sheet.hpp"
#include "json/value.hpp"
#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

class Page : public testing::Test {
 protected:
  static std::string page(Bench bench, const Exercise& exercise, const Heading& heading = {}) {
    const link::Recording recording = bench.record(exercise);
    return sheet_html(examine(recording, exercise, {}, heading), recording, exercise);
  }
};

TEST_F(Page, LoadsNothingAndRunsNothing) {
  const std::string html = page({}, Exercise::limits(six_degrees()));
  for (const char* forbidden : {"src=", "@import", "<link", "url(", "href", "<script", "onload"}) {
    EXPECT_EQ(html.find(forbidden), std::string::npos) << forbidden;
  }
}

TEST_F(Page, StaysSmallHoweverNoisyTheEncoders) {
  Bench bench;
  for (IdealCanard& canard : bench.canards) {
    canard.noise_rad = 1.0 * degree;
  }
  EXPECT_LT(page(bench, Exercise::limits(six_degrees(20.0))).size(), 155'000U);
}

TEST_F(Page, SaysWhatIsWrongWhereItIsSeenFirst) {
  Bench bench;
  bench.canards[2].gain = -1.0;
  const std::string html = page(bench, Exercise::limits(six_degrees()));
  EXPECT_NE(html.find("FAIL"), std::string::npos);
  EXPECT_NE(html.find("<b>Canard 3 is reversed:</b>"), std::string::npos);
  EXPECT_NE(html.find("Signature"), std::string::npos);
  std::size_t plots = 0;
  for (std::size_t at = html.find("<svg class=\"chart"); at != std::string::npos;
       at = html.find("<svg class=\"chart", at + 1)) {
    ++plots;
  }
  EXPECT_EQ(plots, 16U);  // of each canard: alone, together, two steps
}

TEST_F(Page, WhileOthersAreStillToMoveItSaysWhatHasFailedAndGivesNoVerdict) {
  const Exercise whole = Exercise::limits(six_degrees());
  Bench bench;
  bench.canards[1].gain = -1.0;
  const link::Recording recording = bench.record(whole);  // the rest is on its way already
  const auto so_far = [&](std::size_t turns) {
    const Exercise first = whole.beginning(turns);
    return sheet_so_far_html(examine(recording, first, {}, {}), recording, first, 5 - turns);
  };
  const std::string one = so_far(1);
  EXPECT_NE(one.find("<h2>Not finished: 4 more turns to come</h2>"), std::string::npos);
  EXPECT_NE(one.find("<h2>Canard 1 is healthy</h2>"), std::string::npos);
  EXPECT_EQ(one.find("Canard 2"), std::string::npos);
  const std::string four = so_far(4);
  EXPECT_NE(four.find("Not finished: 1 more turn to come"), std::string::npos);
  EXPECT_NE(four.find("<b>Canard 2 is reversed:</b>"), std::string::npos);
  for (const std::string& html : {one, four}) {
    for (const char* verdict : {"PASS", "FAIL", "NO VERDICT", "Signature", "<html"}) {
      EXPECT_EQ(html.find(verdict), std::string::npos) << verdict;
    }
  }
}

TEST_F(Page, OfOneCanardSaysThatTheOthersWereNotMoved) {
  const Exercise one = Exercise::limits_of(six_degrees(), 0);
  const Sheet sheet = examine(Bench{}.record(one), one, {}, {});
  for (const std::string& all : {page({}, one), sheet_text(sheet), sheet_json(sheet)}) {
    EXPECT_NE(all.find("Canards 2, 3 and 4 were not moved."), std::string::npos) << all;
  }
  EXPECT_NE(page({}, one).find("<h2>PASS, canard 1 only</h2>"), std::string::npos);
  EXPECT_NE(sheet_text(sheet).find("\nPASS, canard 1 only\n"), std::string::npos) << sheet_text(sheet);
  const std::string all_four = page({}, Exercise::limits(six_degrees()));
  EXPECT_NE(all_four.find("<h2>PASS</h2>"), std::string::npos);
  EXPECT_EQ(all_four.find("not moved"), std::string::npos);
}

TEST_F(Page, EscapesWhatOthersNamed) {
  const Heading heading{.vehicle = "<script>a", .plan = "b&c", .date = "\"d\"", .notes = {"<e>"}};
  const std::string html = page({}, Exercise::step(six_degrees(), 0, 3.0 * degree), heading);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<e>"), std::string::npos);
  EXPECT_NE(html.find("b&amp;c"), std::string::npos);
}

TEST_F(Page, ShowsAStepAndASineTheSameWay) {
  const Exercise sine =
      Exercise::sine(six_degrees(), 1, {.amplitude_rad = 3.0 * degree, .frequency_hz = 2.0, .cycles = 4});
  for (const Exercise& exercise : {Exercise::step(six_degrees(), 1, 3.0 * degree), sine}) {
    const std::string html = page({}, exercise);
    EXPECT_NE(html.find(exercise.wave() ? "Canard 2 followed the sine" : "Canard 2 went to the commanded angle"),
              std::string::npos);
    EXPECT_LT(html.size(), 60'000U);
  }
}

TEST_F(Page, IsMadeOfAnEmptyRecordingToo) {
  const Exercise exercise = Exercise::limits(six_degrees());
  const Sheet sheet = examine(link::Recording{}, exercise, {}, {});
  EXPECT_NE(sheet_html(sheet, link::Recording{}, exercise).find("NO VERDICT"), std::string::npos);
  EXPECT_FALSE(sheet_text(sheet).empty());
  EXPECT_EQ(json::parse(sheet_json(sheet))["passed"], false);
}

}  // namespace
}  // namespace fantail::bench
