// SPDX-License-Identifier: MIT
#include "files/rows.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "logs/refused.hpp"

namespace fantail::files {
namespace {

using test::expect_refused;
using text::ErrorKind;
using Values = std::vector<double>;

// t in seconds is needed, a in degrees Celsius not.
const std::vector<Found> columns{{.column = 0, .needed = true}, {.column = 1, .offset = 273.15}};

Rows read(const std::string& rows, const Rule& rule = {}, std::vector<Found> found = columns) {
  return read_rows(flight::Table::parse("t,a\n" + rows, "log.csv"), found, rule);
}

TEST(Rows, HaveTheirNumbersInSiAndCountWhatIsNone) {
  const Rows rows = read("0,1\n1,\n2,nan\n3,-273.15\n");
  EXPECT_EQ(rows.values[0], (Values{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(rows.values[1][0], 274.15);
  EXPECT_TRUE(std::isnan(rows.values[1][1]) && std::isnan(rows.values[1][2]));
  EXPECT_EQ(rows.values[1][3], 0.0);
  EXPECT_EQ(rows.lost[1].empty, 1U);
  EXPECT_EQ(rows.lost[1].words, 1U);
  EXPECT_EQ(rows.lost[1].first_row, 1U);
  EXPECT_TRUE(rows.notes.empty());
}

// AltOS writes the largest integer.
TEST(Rows, MayHaveANumberThatMeansNone) {
  std::vector<Found> found = columns;
  found[1].no_value = 2147483647.0;
  EXPECT_TRUE(std::isnan(read("0,2147483647.00\n", {}, found).values[1][0]));
}

TEST(Rows, HaveNoNumberWhereALoggerWritesOneThatMeansNone) {
  const std::vector<Found> metres{{.column = 0, .needed = true}, {.column = 1}};
  for (const char* mark : {"2147483647", "-2147483648.00", "4294967295", "-999", "-9999.0"}) {
    const Rows rows = read("0,1.5\n1," + std::string{mark} + "\n2,-3\n", {}, metres);
    EXPECT_TRUE(std::isnan(rows.values[1][1])) << mark;
    EXPECT_EQ(rows.values[1][2], -3.0) << mark;
    EXPECT_EQ(rows.lost[1].words, 0U) << mark;
  }
  EXPECT_EQ(read("0,-990\n1,-999\n2,-1010\n", {}, metres).values[1][1], -999.0) << "a number among its like";
  EXPECT_EQ(read("0,1\n1,-999\n", {}, metres).notes, std::vector<std::string>{"a has -999 where it has no number."});
}

TEST(Rows, MayHaveTheTimeOfAClockOrOfACalendar) {
  const std::vector<Found> seconds{{.column = 0, .needed = true}, {.column = 1}};
  const auto times = [&](const std::string& text) { return read(text, {}, seconds).values[0]; };
  EXPECT_EQ(times("12:59:59.5,1\n13:00:00.0,1\n"), (Values{0.0, 0.5}));
  EXPECT_EQ(times("23:59:59,1\n00:00:01,1\n"), (Values{0.0, 2.0}));
  EXPECT_EQ(times("2024-02-28T23:59:59Z,1\n2024-02-29 00:00:00.25,1\n"), (Values{0.0, 1.25})) << "a leap year";
  expect_refused(ErrorKind::bad_data, {"required column", "25:00:00"}, [&] { (void)times("25:00:00,1\n"); });
  EXPECT_EQ(read("0:0:1,1\n0:0:2,1\n", {}, seconds).notes.size(), 1U);
}

TEST(Rows, CountOnWhereACounterOfTheTimeBeginsAgain) {
  const std::vector<Found> of_us{{.column = 0, .factor = 1e-6, .needed = true}, {.column = 1}};
  const Rows rows = read("4294966000,1\n4294966500,1\n4294967000,1\n204,1\n704,1\n", {}, of_us);
  ASSERT_EQ(rows.values[0].size(), 5U);
  EXPECT_NEAR(rows.values[0][4] - rows.values[0][3], 500e-6, 1e-9);
  EXPECT_NEAR(rows.values[0][3] - rows.values[0][2], 500e-6, 1e-9);
  EXPECT_EQ(rows.notes, std::vector<std::string>{"t begins again once; it is counted on."});
  expect_refused(ErrorKind::bad_data, {"time must increase"},
                 [&] { (void)read("60000,1\n60010,1\n0,1\n10,1\n", {}, of_us); });
}

TEST(Rows, WithoutANeededNumberAreLeftOutUpToOneInAHundred) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += (i == 40 ? "x" : std::to_string(i)) + ",1\n";
  }
  const Rows rows = read(text);
  EXPECT_EQ(rows.rows.size(), 99U);
  ASSERT_EQ(rows.notes.size(), 1U);
  EXPECT_EQ(rows.notes[0],
            "1 of 100 rows have no number in a required column (first: line 42, t \"x\"); they are left out.");
  expect_refused(ErrorKind::bad_data, {"log.csv: 2 of 101 rows", "line 42, t \"x\"", "more than 1 % is too many"},
                 [&] { (void)read(text + ",1\n"); });
  EXPECT_EQ(read(text + ",1\n", {.most_left_out = 1.0}).rows.size(), 99U);
}

TEST(Rows, MustNotGoBackInTime) {
  expect_refused(ErrorKind::bad_data, {"log.csv:4: t is 0.5 after 1 in line 3: time must increase"},
                 [] { (void)read("0,1\n1,1\n0.5,1\n"); });
}

TEST(Rows, OfOneTimeMustBeIdenticalWhereNobodyKnowsWhichIsRight) {
  const Rows rows = read("0,1\n1,\n1,\n2,1\n");
  EXPECT_EQ(rows.rows, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(rows.notes, std::vector<std::string>{"1 of 4 rows repeat the one before them; they are left out."});
  expect_refused(ErrorKind::bad_data, {"log.csv:4: t is 1 as in line 3, but a differs"},
                 [] { (void)read("0,1\n1,1\n1,2\n"); });
}

TEST(Rows, OfOneTimeTheFirstCountsInAnExportOfASimulator) {
  const Rows rows = read("0,1\n1,1\n1.0000005,2\n2,1\n", {.same_time = SameTime::first_counts, .same_within_s = 1e-6});
  EXPECT_EQ(rows.values[1], (Values{274.15, 274.15, 274.15}));
  ASSERT_EQ(rows.notes.size(), 1U);
  EXPECT_NE(rows.notes[0].find("1 of 4 rows have the time of the row before them, the first in line 4"),
            std::string::npos)
      << rows.notes[0];
}

TEST(Rows, OfOneTimeTheLastNumberOfAColumnCountsInALog) {
  const Rows rows = read("0,1\n1,1\n1,2\n1,\n2,1\n", {.same_time = SameTime::last_of_a_cell});
  EXPECT_EQ(rows.values[1], (Values{274.15, 275.15, 274.15})) << "a cell without a number has no news";
  EXPECT_EQ(rows.read, 5U);
}

TEST(Rows, BeyondWhatIsPossibleAreRefused) {
  std::vector<Found> found = columns;
  found[1].least = 0.0;
  expect_refused(ErrorKind::bad_data, {"log.csv:3: a = \"-274\" is -0.85 in SI; allowed: 0 and more"},
                 [&] { (void)read("0,1\n1,-274\n", {}, found); });
  found[1].most = 300.0;
  expect_refused(ErrorKind::bad_data, {"allowed: 0 to 300"}, [&] { (void)read("0,27\n", {}, found); });
}

TEST(Rows, AreReadWhereAFlagAllowsIt) {
  const Rows rows = read("0,1\n1,no\n2,False\n3,yes\n", {.only_where = 1}, {{.column = 0, .needed = true}});
  EXPECT_EQ(rows.values[0], (Values{0.0, 3.0}));
  EXPECT_EQ(rows.not_used, 2U);
}

TEST(FindColumn, TakesTheNamedOneOrElseOurOwn) {
  const flight::Table table = flight::Table::parse("t,wind_speed_m_s\n0,1\n", "log.csv");
  constexpr std::array asked{Quantity::time};
  const Found time = find_column(table, parse_columns("time=t:ms", "--columns", asked), Quantity::time, "");
  EXPECT_EQ(time.column, 0U);
  EXPECT_EQ(time.factor, 1e-3);
  EXPECT_EQ(find_column(table, {}, Quantity::wind_speed, "").column, 1U);
  expect_refused(ErrorKind::bad_data, {"log.csv: no column time_s", "t, wind_speed_m_s", "--columns time=COLUMN:UNIT"},
                 [&] { (void)find_column(table, {}, Quantity::time, "--columns"); });
}

}  // namespace
}  // namespace fantail::files
