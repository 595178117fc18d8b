// SPDX-License-Identifier: MIT
#include "runs/row_text.hpp"

#include <atomic>
#include <mutex>
#include <thread>

#include "runs/runner.hpp"
#include "test.hpp"

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

const auto look_away = [](std::size_t) {};

TEST(ParallelFor, DoesEveryPieceOfWorkOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    std::array<std::atomic<int>, 50> done{};
    parallel_for(done.size(), threads, [&done](std::size_t i) { ++done[i]; }, look_away);
    for (const auto& times : done) {
      EXPECT_EQ(times, 1) << threads << " threads";
    }
  }
}

TEST(ParallelFor, TakesAtMostFourThreadsForEachProcessor) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallel_for(
      2000, 1000,
      [&](std::size_t) {
        const std::lock_guard lock{mutex};
        seen.insert(std::this_thread::get_id());
      },
      look_away);
  EXPECT_LE(seen.size(), std::size_t{4} * std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ParallelFor, TellsTheCallerOnTheCallersThreadAndAtTheEndThatAllIsDone) {
  std::size_t last = 0;
  const auto caller = std::this_thread::get_id();
  parallel_for(
      5, 2, [](std::size_t) {},
      [&](std::size_t done) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        last = done;
      });
  EXPECT_EQ(last, 5U);
}

TEST(ParallelFor, NothingToDoIsDoneAtOnce) {
  parallel_for(0, 2, [](std::size_t) { FAIL(); }, look_away);
}

}  // namespace

}  // namespace fantail::runs
