// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "text/layout.hpp"

namespace fantail::text {
namespace {

Table example() {
  Table table{{{"what"}, {"least", 2}, {"median"}, {"largest", 1}}};
  table.row({"          ", "     least", "    median", "   largest"});
  table.row({"speed     ", "      10.5", "        12", "      14.5"});
  return table;
}

TEST(Table, IsItsCellsWhereThereIsRoom) {
  const std::string text = "               least    median   largest\nspeed           10.5        12      14.5\n";
  EXPECT_EQ(example().text(any_width), text);
  EXPECT_EQ(example().text(40), text);
}

TEST(Table, LosesBlanksBeforeColumns) {
  EXPECT_EQ(example().text(39), "       least  median  largest\nspeed   10.5      12     14.5\n");
}

TEST(Table, LosesColumnsInTheirOrderAndSaysWhich) {
  EXPECT_EQ(example().text(28),
            "       least  median\nspeed   10.5      12\n  Left out, for the width of this terminal: largest\n");
  EXPECT_EQ(example().text(15),
            "       median\nspeed      12\n  Left out, for the width of this terminal: largest, least\n");
  EXPECT_EQ(example().text(1), example().text(15)) << "the others stay";
}

TEST(Table, ARowMayEndEarly) {
  Table table{{{"a"}, {"b"}}};
  table.row({"a wide row of its own"});
  table.row({"x    ", "   1"});
  table.row_to_its_last_word({"y    ", "    "});
  EXPECT_EQ(table.text(any_width), "a wide row of its own\nx       1\ny\n");
  EXPECT_EQ(table.text(8), "a wide row of its own\nx  1\ny\n");
}

}  // namespace
}  // namespace fantail::text
