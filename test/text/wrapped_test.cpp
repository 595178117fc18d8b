// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "text/layout.hpp"

namespace fantail::text {
namespace {

TEST(Wrapped, LinesThatFitStayAsTheyAre) {
  const std::string text = "one two\n\n  three   four\nfive";
  EXPECT_EQ(wrapped(text, 14), text);
  EXPECT_EQ(wrapped("a line of any length stays in a pipe\n", any_width), "a line of any length stays in a pipe\n");
}

TEST(Wrapped, ASentenceGoesOnTwoColumnsFartherIn) {
  EXPECT_EQ(wrapped("  one two three four\n", 11), "  one two\n    three\n    four\n");
}

TEST(Wrapped, ACellGoesOnBelowItself) {
  EXPECT_EQ(wrapped("  --out DIR   where all of it goes\n", 25), "  --out DIR   where all\n              of it goes\n");
  EXPECT_EQ(wrapped("                        a meaning below its option\n", 44),
            "                        a meaning below its\n                        option\n");
}

TEST(Wrapped, ACellThatWouldBeATowerOfWordsGoesBelowAsAWhole) {
  EXPECT_EQ(wrapped("  a long command line  what it does\n", 30), "  a long command line\n    what it does\n");
}

TEST(Wrapped, ACommentStaysOne) {
  EXPECT_EQ(wrapped("x = 1   # how it begins\n", 18), "x = 1   # how it\n        # begins\n");
}

TEST(Wrapped, AWordIsNeverSplitEvenWhenItIsWiderThanTheLine) {
  EXPECT_EQ(wrapped("page /a/very/long/path/page.html there\n", 12), "page\n  /a/very/long/path/page.html\n  there\n");
}

TEST(Wrapped, ALineOfNothingButBlanksIsAnEmptyOne) {
  EXPECT_EQ(wrapped("a\n" + std::string(50, ' ') + "\nb\n", 40), "a\n\nb\n");
}

TEST(Wrapped, ACommandStaysWhole) {
  EXPECT_EQ(wrapped("again: fantail fly --run 3\n", 20), "again:\n  fantail fly --run 3\n");
  EXPECT_EQ(wrapped("  fantail fly my_rocket --seed 3\n", 20), "  fantail fly my_rocket --seed 3\n");
}

TEST(Wrapped, CharactersCountAndNotTheirBytes) {
  EXPECT_EQ(display_width("\u221220 \u00b0"), 5U);
  EXPECT_EQ(wrapped("\u00b1\u00b1\u00b1\u00b1 \u00b1\u00b1\u00b1\u00b1\n", 9),
            "\u00b1\u00b1\u00b1\u00b1 \u00b1\u00b1\u00b1\u00b1\n");
  EXPECT_EQ(wrapped("\u00b1\u00b1 \u00b1\u00b1\n", 4), "\u00b1\u00b1\n  \u00b1\u00b1\n");
}

TEST(Wrapped, AColourTakesNoRoom) {
  EXPECT_EQ(display_width("\033[31mNo go\033[0m"), 5U);
  EXPECT_EQ(wrapped("\033[31mNo go\033[0m: why\n", 10), "\033[31mNo go\033[0m: why\n");
}

}  // namespace
}  // namespace fantail::text
