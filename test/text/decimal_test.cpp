// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "text/number.hpp"

namespace fantail::text {
namespace {

TEST(Decimal, IsTheNearestDoubleOfAllOfTheText) {
  EXPECT_EQ(decimal("-4.9"), -4.9);
  EXPECT_EQ(decimal("1e-3"), 0.001);
  EXPECT_EQ(decimal("9007199254740993"), 9007199254740992.0);  // between two: the even one
  EXPECT_EQ(decimal(".5"), 0.5);
}

TEST(Decimal, IsNoneOfWhatIsNotWhollyANumber) {
  for (const char* text : {"", "+1", " 1", "1 ", "1,5", "0x10", "1.5.2", "six", "1e400"}) {
    EXPECT_EQ(decimal(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace fantail::text
