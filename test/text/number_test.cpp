// SPDX-License-Identifier: MIT
#include "text/number.hpp"

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

TEST(Number, IsReadToTheLastBitWithSpacesAroundIt) {
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number(" \t-2e-3 \r"), -2e-3);
  EXPECT_EQ(number("+7"), 7.0);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("4.9406564584124654e-324"), 4.9406564584124654e-324) << "the smallest there is";
  EXPECT_EQ(number("0.1"), 0.1);
}

TEST(Number, WhatIsNoFiniteNumberIsNone) {
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "1e999", "1,5", "1 2", "+-1", "++1", "0x10", "1.5m", "-", "e5"}) {
    EXPECT_FALSE(number(text)) << '"' << text << '"';
  }
}

TEST(Number, BeyondAllDecimalsIsPrintedInAFewDigits) {
  EXPECT_EQ(fixed(1e300, 1), "1e+300");
  EXPECT_EQ(fixed(-1.234567e20, 2), "-1.235e+20");
  EXPECT_EQ(brief(1e20, 2), "1e+20");
  EXPECT_EQ(fixed(123456789012345.25, 2), "123456789012345.25");
}

TEST(Flag, IsOneOfFourWordsInWhateverLettersOrAZeroOrAOne) {
  for (const char* on : {"1", " true\r", "True", "YES", "1.0"}) {
    EXPECT_EQ(flag(on), true) << on;
  }
  for (const char* off : {"0", "False", "no", "0.0", "-0"}) {
    EXPECT_EQ(flag(off), false) << off;
  }
  for (const char* none : {"", "2", "-1", "0.4", "nan", "y", "on"}) {
    EXPECT_EQ(flag(none), std::nullopt) << none;
  }
}

TEST(Trimmed, LosesSpacesTabsAndACarriageReturnAtTheEndAndNothingInside) {
  EXPECT_EQ(trimmed("  a b\t \r"), "a b");
  EXPECT_EQ(trimmed("\ra"), "\ra");
  EXPECT_EQ(trimmed(" \t "), "");
}

TEST(WholeNumber, IsDigitsAndNothingElseUpToTheLargest) {
  EXPECT_EQ(whole_number("0"), 0U);
  EXPECT_EQ(whole_number("18446744073709551615"), 18446744073709551615U);
  for (const char* none : {"", "-1", "+1", " 1", "1 ", "1.0", "0x1", "18446744073709551616"}) {
    EXPECT_EQ(whole_number(none), std::nullopt) << none;
  }
}

}  // namespace
}  // namespace fantail::text
