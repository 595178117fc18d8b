// SPDX-License-Identifier: MIT
#include "fantail/progress.hpp"

#include <gtest/gtest.h>

namespace fantail::tool {
namespace {

TEST(ProgressLine, SaysHowFarHowFastAndHowLongStill) {
  EXPECT_EQ(progress_line("flying x", {.unit = "runs", .rate = " a second", .total = 60.0}, 12.0, 1.0),
            "flying x: 12 of 60 runs, 12 a second, 4 s to go");
  EXPECT_EQ(progress_line("paper", {.unit = "chapters", .rate = " a second", .total = 8.0}, 3.0, 6.0),
            "paper: 3 of 8 chapters, 0.5 a second, 10 s to go");
}

TEST(ProgressLine, OfAFewSecondsDoesNotRoundWhatIsStillToDoAway) {
  EXPECT_EQ(progress_line("canards", {.unit = "s", .rate = " x real time", .total = 3.3}, 2.6, 48.0),
            "canards: 2.6 of 3.3 s, 0.054 x real time, 13 s to go");
}

TEST(ProgressLine, SaysNothingThatIsNotKnown) {
  EXPECT_EQ(progress_line("paper", {.unit = "chapters", .rate = " a second", .total = 8.0}, 0.0, 6.0),
            "paper: 0 of 8 chapters");
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

}  // namespace
}  // namespace fantail::tool
