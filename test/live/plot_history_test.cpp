// SPDX-License-Identifier: MIT
#include "live/plot_history.hpp"

#include <gtest/gtest.h>

#include "json/value.hpp"

namespace fantail::live {
namespace {

using hal::Microseconds;
using json::Value;

Sample roll(double degrees) { return {degrees}; }

// Begin and end in ms, and the two values of the first signal in hundredths.
std::array<double, 4> first(const Value& row) {
  return {row[0].number(), row[1].number(), row[2].number(), row[3].number()};
}

TEST(PlotHistory, AStretchKeepsItsExtremesInTheOrderOfTheirTime) {
  PlotHistory plots{signals};
  for (const auto& [ms, degrees] : std::vector<std::pair<int, double>>{{0, 1.0}, {1, -7.5}, {2, 9.0}, {3, 2.0}}) {
    plots.add(Microseconds{1000 * ms}, roll(degrees));
  }
  const Value up = plots.take_news();
  ASSERT_EQ(up.size(), 1U);
  EXPECT_EQ(first(up[0]), (std::array{0.0, 3.0, -750.0, 900.0}));
  for (const auto& [ms, degrees] : std::vector<std::pair<int, double>>{{4, 1.0}, {5, 9.0}, {6, -7.5}}) {
    plots.add(Microseconds{1000 * ms}, roll(degrees));
  }
  EXPECT_EQ(first(plots.take_news()[0]), (std::array{4.0, 6.0, 900.0, -750.0}));
}

TEST(PlotHistory, AKilohertzBecomesFortyStretchesASecondAndNoneOfThemTwice) {
  PlotHistory plots{signals};
  for (int ms = 0; ms < 1000; ++ms) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
  }
  const Value news = plots.take_news();
  ASSERT_EQ(news.size(), 40U);
  EXPECT_EQ(first(news[39]), (std::array{975.0, 999.0, 97500.0, 99900.0}));
  EXPECT_EQ(plots.take_news().size(), 0U);
  plots.add(Microseconds{1'000'000}, roll(5.0));
  EXPECT_EQ(first(plots.take_news()[0]), (std::array{1000.0, 1000.0, 500.0, 500.0}));
}

TEST(PlotHistory, WhoComesLateIsToldWhatOthersWereAndNotWhatTheyWillBe) {
  PlotHistory plots{signals};
  plots.add(Microseconds{0}, roll(1.0));
  (void)plots.take_news();
  plots.add(Microseconds{30'000}, roll(2.0));
  const Value told = plots.all_told();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(first(told[0])[2], 100.0);
  EXPECT_EQ(plots.take_news().size(), 1U);
  EXPECT_EQ(plots.all_told().size(), 2U);
}

TEST(PlotHistory, HalfAMinuteIsKept) {
  PlotHistory plots{signals};
  for (int ms = 0; ms <= 60'000; ms += 10) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
    if (ms % 1000 == 0) {
      (void)plots.take_news();
    }
  }
  const Value all = plots.all_told();
  EXPECT_GE(all[0][1].number(), 30'000.0);
  EXPECT_LE(all[0][0].number(), 30'100.0);
  // Nobody takes them: then no more is waiting than is kept.
  for (int ms = 60'010; ms <= 180'000; ms += 10) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
  }
  EXPECT_LE(plots.take_news().size(), 1201U);
}

TEST(PlotHistory, WhatIsUnknownIsNullAndWhatIsOldIsLeftOut) {
  PlotHistory plots{signals};
  plots.add(Microseconds{5'000}, Sample{std::nullopt, 3.0, std::nan(""), 1e300});
  plots.add(Microseconds{5'000}, roll(7.0));
  plots.add(Microseconds{4'000}, roll(7.0));
  const Value news = plots.take_news();
  ASSERT_EQ(news.size(), 1U);
  EXPECT_TRUE(news[0][2].is_null());
  EXPECT_EQ(news[0][4].number(), 300.0);
  EXPECT_TRUE(news[0][6].is_null());
  EXPECT_TRUE(news[0][8].is_null()) << "no browser could add it to anything";
  EXPECT_EQ(news[0].size(), 2U + 2U * signals);
}

}  // namespace
}  // namespace fantail::live
