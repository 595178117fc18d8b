// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "page/svg_plot.hpp"
#include "seed.hpp"

namespace fantail::page {
namespace {

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
