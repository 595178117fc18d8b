// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "fantail/help.hpp"
#include "test.hpp"
#include "text/layout.hpp"

namespace fantail::tool {
namespace {

constexpr const char* text =
    "Exit code 0: flown.\n"
    "Examples:\n"
    "  fantail fly                         the second launch\n"
    "  fantail fly a --set b.c=hold --set d.e=9\n"
    "                                      would a wider canard limit have held it?\n"
    "  fantail x run.csv --speed 22 \\\n"
    "      --area 5 --json                 for a script\n"
    "\n"
    "More of it: elsewhere.";

TEST(Examples, StayAsTheyAreWhereTheyFit) {
  EXPECT_EQ(examples_text(text, text::any_width), std::string{text} + "\n");
  EXPECT_EQ(examples_text(text, 78), std::string{text} + "\n");  // the longest line
}

TEST(Examples, InANarrowPlaceStandAboveTheirMeaningAndGoOnAfterABackslash) {
  EXPECT_EQ(examples_text(text, 36),
            "Exit code 0: flown.\n"
            "Examples:\n"
            "  fantail fly\n"
            "    the second launch\n"
            "  fantail fly a --set b.c=hold \\\n"
            "      --set d.e=9\n"
            "    would a wider canard limit have\n"
            "      held it?\n"
            "  fantail x run.csv --speed 22 \\\n"
            "      --area 5 --json\n"
            "    for a script\n"
            "\n"
            "More of it: elsewhere.\n");
}

TEST(Examples, WhatIsQuotedIsNotBroken) {
  EXPECT_EQ(examples_text("  fantail a --share 'x --y z' --w\n", 26),
            "  fantail a \\\n      --share 'x --y z' \\\n      --w\n");
}

}  // namespace
}  // namespace fantail::tool
