// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "text/quoting.hpp"

namespace fantail::text {
namespace {

TEST(CsvCell, IsTheTextItselfWhereNoReaderMistakesIt) {
  EXPECT_EQ(csv_cell(""), "");
  EXPECT_EQ(csv_cell("held 3.5 deg"), "held 3.5 deg");
}

TEST(CsvCell, IsInQuotesAndOnOneLineWhereAReaderWouldTakeItForMore) {
  EXPECT_EQ(csv_cell("a, b"), "\"a, b\"");
  EXPECT_EQ(csv_cell("says \"no\""), "\"says \"\"no\"\"\"");
  EXPECT_EQ(csv_cell("one\r\ntwo"), "\"one  two\"");
  EXPECT_EQ(csv_cell("# no remark"), "\"# no remark\"");
}

}  // namespace
}  // namespace fantail::text
