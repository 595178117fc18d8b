// SPDX-License-Identifier: MIT
#include "runs/row_text.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace fantail::runs {
namespace {

enum class Word : std::uint8_t { one, two };

struct Inner {
  double value = 0.0;
  std::optional<double> maybe{};

  friend bool operator==(const Inner&, const Inner&) = default;
};
void fields(RowText& text, Inner& row) { text(row.value, row.maybe); }

struct Row {
  std::uint64_t seed = 0;
  int number = 0;
  bool is = false;
  Word word = Word::one;
  std::string said{};
  std::vector<Inner> list{};
  std::array<Inner, 2> two{};
  std::map<int, std::uint64_t> counts{};

  friend bool operator==(const Row&, const Row&) = default;
};
void fields(RowText& text, Row& row) {
  text(row.seed, row.number, row.is, row.word, row.said, row.list, row.two, row.counts);
}

Row full() {
  return {.seed = std::numeric_limits<std::uint64_t>::max(),
          .number = -7,
          .is = true,
          .word = Word::two,
          .said = "a text,\nwith 3 5:spaces and \xff\0 bytes ",
          .list = {{.value = 0.1, .maybe = 1e-320}, {.value = -0.0}},
          .two = {{{.value = std::numeric_limits<double>::infinity(), .maybe = 1.0 / 3.0}, {}}},
          .counts = {{-3, 5}, {200, 1}}};
}

std::string text_of(Row row) {
  RowText text;
  text(row);
  return text.text();
}

TEST(RowText, ComesBackBitForBit) {
  for (const Row& row : {Row{}, full()}) {
    std::vector<Row> back{{.seed = 3, .said = "old", .list = {{}}, .counts = {{1, 1}}}};
    ASSERT_TRUE(read_rows(text_of(row), back)) << text_of(row);
    EXPECT_EQ(back[0], row);
    EXPECT_EQ(text_of(back[0]), text_of(row));
  }
  std::vector<Row> minus(1);
  ASSERT_TRUE(read_rows(text_of(full()), minus));
  EXPECT_TRUE(std::signbit(minus[0].list[1].value));
}

bool is_text_of(const std::string& text, std::size_t count) {
  std::vector<Row> all(count);
  return read_rows(text, all);
}

TEST(RowText, OfOneRowIsNotThatOfNoneOrTwo) {
  const std::string text = text_of(full());
  EXPECT_FALSE(is_text_of(text, 0));
  EXPECT_FALSE(is_text_of(text, 2));
  EXPECT_TRUE(is_text_of(text + text, 2));
}

TEST(RowText, CutAtAnyCharacterIsRefused) {
  const std::string text = text_of(full());
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_FALSE(is_text_of(text.substr(0, size), 1)) << size;
  }
}

TEST(RowText, WithACountThatNobodyHasRoomForIsRefused) {
  EXPECT_FALSE(is_text_of("0 0 0 0 0  18446744073709551615 ", 1));
  EXPECT_FALSE(is_text_of("0 0 0 0 99999999999:x ", 1));
}

}  // namespace
}  // namespace fantail::runs
