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
