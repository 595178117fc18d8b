// SPDX-License-Identifier: MIT
#include "fantail/terminal.hpp"

#include <filesystem>
#include <fstream>

#include "fantail/deliver.hpp"
#include "fantail/live_screen.hpp"
#include "fantail/progress.hpp"
#include "fantail/terminal.hpp"
#include "test.hpp"
namespace fantail::tool {
namespace {

TEST(Color, IsForATerminalThatHasIt) {
  EXPECT_TRUE(may_have_color(ColorWish::automatic, true, nullptr, "xterm"));
  EXPECT_FALSE(may_have_color(ColorWish::automatic, false, nullptr, "xterm")) << "a pipe";
  EXPECT_FALSE(may_have_color(ColorWish::automatic, true, nullptr, "dumb"));
  EXPECT_FALSE(may_have_color(ColorWish::automatic, true, nullptr, nullptr)) << "nobody said which terminal";
}

TEST(Color, IsNotForWhoSetsNoColorToAnythingButNothing) {
  EXPECT_FALSE(may_have_color(ColorWish::automatic, true, "1", "xterm"));
  EXPECT_FALSE(may_have_color(ColorWish::automatic, true, "0", "xterm"));
  EXPECT_TRUE(may_have_color(ColorWish::automatic, true, "", "xterm"));
}

TEST(Color, IsAsTheCommandLineAsksWhateverTheSurroundings) {
  EXPECT_TRUE(may_have_color(ColorWish::always, false, "1", "dumb"));
  EXPECT_FALSE(may_have_color(ColorWish::never, true, nullptr, "xterm"));
}

TEST(Columns, AreThoseOfTheTerminalUpToWhatCanBeRead) {
  EXPECT_EQ(readable_columns(80), 80U);
  EXPECT_EQ(readable_columns(60), 60U);
  EXPECT_EQ(readable_columns(30), 30U);
  EXPECT_EQ(readable_columns(10), 20U);
  EXPECT_EQ(readable_columns(300), 120U);
  EXPECT_EQ(readable_columns(0), 80U) << "one that does not know its width";
}

// Text of a file: a colour, a bell, a line that is overwritten, and the one byte that begins a sequence, too.
TEST(Controls, OfAFileAreQuestionMarksAndColoursOfOursStay) {
  EXPECT_EQ(without_controls("a\033[31mred\a\rb\u009b2J \u00e9\n"), "a?[31mred??b??2J \u00e9\n");
  EXPECT_EQ(without_controls("\033[31mred\033[0m \033[2J", true), "\033[31mred\033[0m ?[2J");
}

class Painted : public testing::Test {
 protected:
  Painted() { set_color("always"); }
  ~Painted() override { set_color("auto"); }
};

TEST_F(Painted, ADecisionIsSoWhereALineBeginsWithIt) {
  EXPECT_EQ(painted_decision("a PASS\nPASS\n  FAIL\nFAIL\nOutside the model: Mach 1.27.\n"),
            "a PASS\n\033[32mPASS\033[0m\n  FAIL\n\033[31mFAIL\033[0m\n\033[33mOutside the model\033[0m: Mach 1.27.\n");
}

TEST_F(Painted, APhaseIsSoAndOnlyThatWord) {
  EXPECT_EQ(
      painted_phase("motion  live\n  phase safe (power_on)\nphase armed\nphase controlling (x)\nphase finished\n"),
      "motion  live\n  phase \033[32msafe\033[0m (power_on)\nphase \033[33marmed\033[0m\n"
      "phase \033[36mcontrolling\033[0m (x)\nphase finished\n");
}

TEST_F(Painted, NothingIsWhenNobodyWantsColours) {
  set_color("never");
  EXPECT_EQ(painted_decision("PASS\n"), "PASS\n");
  EXPECT_EQ(painted_phase("phase safe\n"), "phase safe\n");
}

TEST(ProgressLine, SaysHowFarHowFastAndHowLongStill) {
  EXPECT_EQ(progress_line("flying x", {.unit = "runs", .rate = " a second", .total = 60.0}, 12.0, 1.0),
            "flying x: 12 of 60 runs, 12 a second, 4 s to go");
  EXPECT_EQ(progress_line("identifying steps", {.unit = "steps", .rate = " a second", .total = 8.0}, 3.0, 6.0),
            "identifying steps: 3 of 8 steps, 0.5 a second, 10 s to go");
}

TEST(ProgressLine, OfAFewSecondsDoesNotRoundWhatIsStillToDoAway) {
  EXPECT_EQ(progress_line("moving the canards", {.unit = "s", .rate = " x real time", .total = 3.3}, 2.6, 48.0),
            "moving the canards: 2.6 of 3.3 s, 0.054 x real time, 13 s to go");
}

TEST(ProgressLine, SaysNothingThatIsNotKnown) {
  EXPECT_EQ(progress_line("identifying steps", {.unit = "steps", .rate = " a second", .total = 8.0}, 0.0, 6.0),
            "identifying steps: 0 of 8 steps");
  EXPECT_EQ(progress_line("searching", {.unit = "steps", .rate = " a second", .total = {}}, 9.0, 1.0),
            "searching: 9 steps, 9 a second");
}

TEST(ProgressLine, CountsALongTimeInMinutes) {
  EXPECT_EQ(progress_line("flying", {.unit = "runs", .rate = " a second", .total = 1200.0}, 100.0, 100.0),
            "flying: 100 of 1200 runs, 1 a second, 18 min to go");
}

TEST(ProgressLine, SaysNoTotalThatTurnedOutTooSmall) {
  EXPECT_EQ(progress_line("flying", {.unit = "s", .rate = " x real time", .total = 10.0}, 20.0, 1.0),
            "flying: 20 s, 20 x real time");
}

TEST(ProgressLine, OfAPartNamesTheWorkBeforeItsNumber) {
  EXPECT_EQ(chapter_line("log export", "reading flown.ftl", 1, 2, 4.2),
            "log export: reading flown.ftl (part 1 of 2), 4 s");
}

TEST(ProgressLine, OfWorkInOnePartHasNoNumber) {
  EXPECT_EQ(chapter_line("merge", "joining the runs of 3 shards", 1, 1, 130.0),
            "merge: joining the runs of 3 shards, 2 min");
}

const std::string begin = "\033[?2026h\033[?25l\033[?7l\033[H";
const std::string end = "\033[J\033[?7h\033[?25h\033[?2026l";

TEST(LiveFrame, DrawsEachLineToItsEndOverTheOneBeforeAndClearsOnlyWhatIsBelow) {
  EXPECT_EQ(live_frame("one\n\ntwo\n", 80, 24), begin + "one\033[K\r\n\033[K\r\ntwo\033[K" + end);
}

TEST(LiveFrame, LeavesOutWhatTheTerminalHasNoRowsForAndSaysHowMuch) {
  EXPECT_EQ(live_frame("1\n2\n3\n4\n", 80, 4), begin + "1\033[K\r\n2\033[K\r\n3\033[K\r\n4\033[K" + end);
  EXPECT_EQ(live_frame("1\n2\n3\n4\n", 80, 3),
            begin + "1\033[K\r\n2\033[K\r\n(2 more lines: the terminal is too low)\033[K" + end);
}

TEST(LiveFrame, BreaksLinesThatAreTooWide) {
  EXPECT_EQ(live_frame("one two three\n", 10, 24), begin + "one two\033[K\r\n  three\033[K" + end);
}

namespace fs = std::filesystem;

// The digest of "abc" is the example of FIPS 180-4. A log that somebody has moved away costs no result.
TEST(Made, HashesTheFilesThatAreThereAndOnlyThose) {
  const fs::path folder = fs::path{testing::TempDir()} / "made_with";
  fs::create_directories(folder);
  std::ofstream{folder / "plan.toml"} << "abc";
  const result::Made made = made_with({folder / "plan.toml", folder / "moved_away.csv", folder, ""}, 7, {"a.b=c"});
  ASSERT_EQ(made.inputs.size(), 1U);
  EXPECT_EQ(made.inputs[0].file, "plan.toml");
  EXPECT_EQ(made.inputs[0].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(made.seed, 7U);
  EXPECT_EQ(made.changes, std::vector<std::string>{"a.b=c"});

  fs::create_directories(folder / "vehicles");
  std::ofstream{folder / "vehicles" / "plan.toml"} << "abcd";
  const result::Made both = made_with({folder / "plan.toml", folder / "vehicles" / "plan.toml"}, {}, {});
  ASSERT_EQ(both.inputs.size(), 2U);
  EXPECT_EQ(both.inputs[0].file, "made_with/plan.toml");
  EXPECT_EQ(both.inputs[1].file, "vehicles/plan.toml");
  fs::remove_all(folder);
}

}  // namespace

}  // namespace fantail::tool
