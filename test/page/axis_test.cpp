// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "page/svg_plot.hpp"
#include "seed.hpp"

namespace fantail::page {
namespace {

std::vector<std::string> texts(const std::vector<Tick>& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks) {
    result.push_back(tick.text);
  }
  return result;
}

using Texts = std::vector<std::string>;

TEST(Axis, TicksAreRoundNumbersWithRealMinusSigns) {
  EXPECT_EQ(texts(even_ticks({-10.0, 10.0}, 5.0)), (Texts{"\u221210", "\u22125", "0", "5", "10"}));
  EXPECT_EQ(texts(even_ticks({0.0, 0.4}, 4.0)), (Texts{"0", "0.1", "0.2", "0.3", "0.4"}));
}

TEST(Axis, TicksStayInsideTheRangeAndAreNearTheNumberWanted) {
  std::mt19937 random{test::seed(5)};
  std::uniform_real_distribution<double> exponent{-8.0, 8.0};
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, exponent(random));
    const double low = size * std::uniform_real_distribution<double>{-2.0, 2.0}(random);
    const Range range{low, low + size};
    const auto ticks = even_ticks(range, 6.0);
    ASSERT_GE(ticks.size(), 3U) << low << " + " << size;
    ASSERT_LE(ticks.size(), 11U) << low << " + " << size;
    for (const Tick& tick : ticks) {
      ASSERT_GE(tick.value, range.low - 1e-6 * size);
      ASSERT_LE(tick.value, range.high + 1e-6 * size);
    }
  }
}

TEST(Axis, VeryLargeAndVerySmallTicksAreWrittenWithAPowerOfTen) {
  EXPECT_EQ(texts(even_ticks({0.0, 4e7}, 2.0)), (Texts{"0", "2·10⁷", "4·10⁷"}));
  EXPECT_EQ(texts(even_ticks({-2e-7, 2e-7}, 2.0)), (Texts{"\u22122·10⁻⁷", "0", "2·10⁻⁷"}));
}

TEST(Axis, TicksFarFromZeroCanBeToldApart) {
  EXPECT_EQ(texts(even_ticks({1'700'000'000.0, 1'700'000'002.0}, 2.0)),
            (Texts{"1700000000", "1700000001", "1700000002"}));
}

TEST(Axis, DecadesAreCutInOneTwoFive) {
  EXPECT_EQ(texts(decade_ticks({0.1, 10.0}, 7.0)), (Texts{"0.1", "0.2", "0.5", "1", "2", "5", "10"}));
  EXPECT_EQ(texts(decade_ticks({0.01, 1000.0}, 6.0)), (Texts{"0.01", "0.1", "1", "10", "100", "1000"}));
}

TEST(Axis, ANarrowPieceOfADecadeStillHasTicks) { EXPECT_GE(decade_ticks({2.1, 3.9}, 5.0).size(), 3U); }

TEST(Axis, TicksAtPointsAreOnceEachAndOnlyInside) {
  EXPECT_EQ(texts(ticks_at(std::vector{3.0, 1.0, 3.0, 9.0}, {0.0, 5.0})), (Texts{"1", "3"}));
}

TEST(Axis, AnyRangeCanBeDrawn) {
  constexpr double gone = std::numeric_limits<double>::quiet_NaN();
  constexpr double endless = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max();
  for (const Range range :
       {Range{0, 0}, Range{5, 5}, Range{-3, -3}, Range{gone, gone}, Range{gone, 1}, Range{1, gone},
        Range{-endless, endless}, Range{-most, most}, Range{2, 1}, Range{1e9, 1e9 + 1e-7}, Range{1e-300, 1e-300}}) {
    const Range fit = drawable(range);
    EXPECT_LT(fit.low, fit.high) << range.low << ' ' << range.high;
    EXPECT_TRUE(std::isfinite(fit.high - fit.low));
    EXPECT_LE(even_ticks(fit, 5.0).size(), 12U);
  }
  EXPECT_DOUBLE_EQ(drawable({5, 5}).low, 4.5);
  EXPECT_DOUBLE_EQ(drawable({5, 5}).high, 5.5);
}

TEST(Axis, ARangeGrowsByNumbersOnly) {
  std::optional<Range> range;
  include(range, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(range);
  include(range, 2.0);
  include(range, std::numeric_limits<double>::infinity());
  include(range, -1.0);
  EXPECT_EQ(range->low, -1.0);
  EXPECT_EQ(range->high, 2.0);
}

}  // namespace
}  // namespace fantail::page
