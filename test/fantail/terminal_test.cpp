// SPDX-License-Identifier: MIT
#include "fantail/terminal.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fantail::tool
