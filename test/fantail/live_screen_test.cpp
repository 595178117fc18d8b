// SPDX-License-Identifier: MIT
#include "fantail/live_screen.hpp"

#include <gtest/gtest.h>

namespace fantail::tool {
namespace {

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

}  // namespace
}  // namespace fantail::tool
