// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "page/heat_map.hpp"
#include "page/svg_plot.hpp"
#include "seed.hpp"
#include "test.hpp"

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

TEST(Axis, ALogarithmicScaleGivesEqualRatiosEqualLengths) {
  const Range range{0.1, 100.0};
  for (const auto& [value, part] : {std::pair{0.1, 0.0}, {1.0, 1.0 / 3.0}, {10.0, 2.0 / 3.0}, {100.0, 1.0}}) {
    EXPECT_NEAR(part_of(value, range, Scale::logarithmic), part, 1e-12) << value;
  }
  EXPECT_NEAR(part_of(2.0, {1.0, 5.0}, Scale::linear), 0.25, 1e-12);
  for (const double none : {0.0, -1.0}) {
    EXPECT_LT(part_of(none, range, Scale::logarithmic), -10.0);
    EXPECT_TRUE(std::isfinite(part_of(none, range, Scale::logarithmic)));
  }
}

TEST(Axis, ALogarithmicRangeIsAboveZeroWhateverCameIn) {
  for (const Range range : {Range{0.0, 10.0}, Range{-5.0, 10.0}, Range{-3.0, -2.0}, Range{0.0, 0.0}, Range{2.0, 8.0}}) {
    const Range fit = drawable(range, Scale::logarithmic);
    EXPECT_GT(fit.low, 0.0) << range.low << ' ' << range.high;
    EXPECT_GT(fit.high, fit.low);
  }
  EXPECT_EQ(drawable(Range{2.0, 8.0}, Scale::logarithmic).low, 2.0);
  EXPECT_EQ(drawable(Range{0.0, 10.0}, Scale::logarithmic).high, 10.0);
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

double linear(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }

// CIE 1976 L*, a*, b* of an sRGB colour.
std::array<double, 3> lab(Colour colour) {
  const double r = linear(colour.red / 255.0);
  const double g = linear(colour.green / 255.0);
  const double b = linear(colour.blue / 255.0);
  const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(ColourScale, GetsLighterAllTheWay) {
  for (int i = 0; i < 100; ++i) {
    EXPECT_LT(lab(colour_at(i / 100.0))[0], lab(colour_at((i + 1) / 100.0))[0]) << i;
  }
}

TEST(ColourScale, EqualStepsLookAboutEqual) {
  std::array<double, 16> steps{};
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto a = lab(colour_at(static_cast<double>(i) / 16.0));
    const auto b = lab(colour_at(static_cast<double>(i + 1) / 16.0));
    steps[i] = b[0] - a[0];  // lightness: what is left without colour vision
    sum += steps[i];
  }
  for (const double step : steps) {
    EXPECT_GT(step, 0.6 * sum / 16.0);
    EXPECT_LT(step, 1.4 * sum / 16.0);
  }
}

TEST(ColourScale, OutsideItEndsAreHeld) {
  EXPECT_EQ(colour_at(-3.0), colour_at(0.0));
  EXPECT_EQ(colour_at(7.0), colour_at(1.0));
  EXPECT_NE(colour_at(0.0), colour_at(1.0));
}

bool holds(const std::vector<std::size_t>& kept, std::size_t index) {
  return std::binary_search(kept.begin(), kept.end(), index);
}

TEST(Thinning, KeepsASpikeOfOneSampleInAnySeries) {
  std::vector<std::vector<double>> series(2, std::vector<double>(20'000, 1.0));
  series[0][12'345] = 50.0;
  series[1][777] = -50.0;
  const auto kept = keep_extremes(series, 100);
  EXPECT_TRUE(holds(kept, 12'345));
  EXPECT_TRUE(holds(kept, 777));
  EXPECT_LE(kept.size(), 100U * 5U + 1U);
}

TEST(Thinning, KeepsFirstAndLastAndIncreases) {
  const std::vector<std::vector<double>> series(1, std::vector<double>(9'999, 0.0));
  const auto kept = keep_extremes(series, 50);
  EXPECT_EQ(kept.front(), 0U);
  EXPECT_EQ(kept.back(), 9'998U);
  EXPECT_TRUE(std::ranges::is_sorted(kept, std::less_equal<>{}));
}

TEST(Thinning, LeavesAShortSeriesAlone) {
  const std::vector<std::vector<double>> series(1, std::vector<double>(30, 0.0));
  EXPECT_EQ(keep_extremes(series, 10).size(), 30U);
  EXPECT_TRUE(keep_extremes({}, 10).empty());
}

TEST(Thinning, SkipsWhatIsNotANumber) {
  std::vector<std::vector<double>> series(1, std::vector<double>(1'000, std::numeric_limits<double>::quiet_NaN()));
  series[0][503] = 1.0;
  series[0][507] = 3.0;
  series[0][509] = 2.0;
  const auto kept = keep_extremes(series, 10);
  EXPECT_TRUE(holds(kept, 503));
  EXPECT_TRUE(holds(kept, 507));
}

TEST(Thinning, EveryStretchKeepsItsSmallestAndLargestValueOfNoise) {
  std::mt19937 random{test::seed(20'151'204)};
  std::vector<std::vector<double>> series(3, std::vector<double>(10'000));
  for (auto& values : series) {
    std::ranges::generate(values, [&] { return static_cast<double>(random()); });
  }
  const auto kept = keep_extremes(series, 100);
  for (const auto& values : series) {
    for (std::size_t begin = 0; begin < values.size(); begin += 100) {
      const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   values.begin() + static_cast<std::ptrdiff_t>(begin + 100));
      EXPECT_TRUE(holds(kept, static_cast<std::size_t>(low - values.begin())));
      EXPECT_TRUE(holds(kept, static_cast<std::size_t>(high - values.begin())));
    }
  }
}

TEST(Thinning, AGapIsFiveTimesTheUsualStep) {
  EXPECT_EQ(gaps(std::vector<double>{0, 1, 2, 3, 9, 10, 15}), std::vector<std::size_t>{4});
  EXPECT_TRUE(gaps(std::vector<double>{0, 1}).empty());
  EXPECT_TRUE(gaps({}).empty());
}

}  // namespace

}  // namespace fantail::page
