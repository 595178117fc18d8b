// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/confidence_sequence.hpp"
#include "campaign/sensitivity.hpp"
#include "campaign/unit_points.hpp"
#include "seed.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

// Of n runs that all had it: n ln p > ln(0.05 / (n + 1)).
TEST(ConfidenceSequence, OfRunsThatAllHadItHasItsClosedForm) {
  for (const std::uint64_t runs : {1U, 10U, 1'000U, 1'000'000U}) {
    const auto n = static_cast<double>(runs);
    const double low = std::exp(std::log(0.05 / (n + 1.0)) / n);
    const Bounds all = confidence_sequence(runs, runs);
    EXPECT_NEAR(all.low, low, 1e-12);
    EXPECT_EQ(all.high, 1.0);
    const Bounds none = confidence_sequence(0, runs);
    EXPECT_NEAR(none.high, 1.0 - low, 1e-12);
    EXPECT_EQ(none.low, 0.0);
  }
  EXPECT_EQ(confidence_sequence(0, 0).low, 0.0);
  EXPECT_EQ(confidence_sequence(0, 0).high, 1.0);
}

// 200 campaigns, each looked at after every run: 5 % may miss, 10 of them; 23 or more would be a chance of
// 1e-4.
TEST(ConfidenceSequence, MissesTheTrueShareInNoMoreThanOneCampaignOfTwentyHoweverOftenItIsLookedAt) {
  constexpr int campaigns = 200;
  constexpr std::uint64_t runs = 500;
  for (const double share : {0.5, 0.95}) {
    const std::uint32_t seed = test::seed(1);
    int missed = 0;
    for (int campaign = 0; campaign < campaigns; ++campaign) {
      sim::Random random{seed, static_cast<std::uint64_t>(campaign)};
      std::uint64_t count = 0;
      bool misses = false;
      for (std::uint64_t run = 1; run <= runs && !misses; ++run) {
        count += random.uniform() < share ? 1 : 0;
        const Bounds bounds = confidence_sequence(count, run);
        misses = share < bounds.low || share > bounds.high;
      }
      missed += misses ? 1 : 0;
    }
    EXPECT_LT(missed, 23) << share;
  }
}

TEST(ConfidenceSequence, GetsNarrow) {
  const Bounds bounds = confidence_sequence(9'000, 10'000);
  EXPECT_LT(bounds.high - bounds.low, 0.03);
  EXPECT_LT(bounds.low, 0.9);
  EXPECT_GT(bounds.high, 0.9);
}

/// Even points, one list a quantity.
std::vector<std::vector<double>> points(std::size_t dimensions, std::uint64_t runs) {
  const UnitPoints unit{Sampling::sobol, 3, runs};
  std::vector<std::vector<double>> all(dimensions);
  for (std::size_t i = 0; i < dimensions; ++i) {
    for (std::uint64_t run = 0; run < runs; ++run) {
      all[i].push_back(unit.at(run, i));
    }
  }
  return all;
}

// y = 3 a - 4 b + c with even quantities of the same width: slopes 3, -4 and 1 over sqrt(26), shares 9, 16 and 1 of 26.
TEST(Sensitivity, OfStraightLinesIsTheirClosedForm) {
  constexpr std::uint64_t runs = 4096;
  const auto x = points(3, runs);
  std::vector<double> y;
  for (std::size_t run = 0; run < runs; ++run) {
    y.push_back(7.0 + 3.0 * x[0][run] - 4.0 * x[1][run] + x[2][run]);
  }
  const Sensitivity all = sensitivity(x, y, 1);
  EXPECT_NEAR(all.explained, 1.0, 1e-12);
  const double root = std::sqrt(26.0);
  EXPECT_NEAR(all.of_quantity[0].slope.value().value, 3.0 / root, 2e-3);
  EXPECT_NEAR(all.of_quantity[1].slope.value().value, -4.0 / root, 2e-3);
  EXPECT_NEAR(all.of_quantity[2].slope.value().value, 1.0 / root, 2e-3);
  EXPECT_NEAR(all.of_quantity[0].variance_share.value, 9.0 / 26.0, 0.02);
  EXPECT_NEAR(all.of_quantity[1].variance_share.value, 16.0 / 26.0, 0.02);
  EXPECT_NEAR(all.of_quantity[2].variance_share.value, 1.0 / 26.0, 0.02);
}

// Ishigami's function: sin a + 7 sin^2 b + 0.1 c^4 sin a has shares of 0.3139, 0.4424 and 0; no line sees b.
TEST(Sensitivity, SeesWhatNoStraightLineShows) {
  constexpr std::uint64_t runs = 8192;
  const auto x = points(3, runs);
  std::vector<double> y;
  for (std::size_t run = 0; run < runs; ++run) {
    const auto angle = [&](std::size_t i) { return std::numbers::pi * (2.0 * x[i][run] - 1.0); };
    y.push_back(std::sin(angle(0)) + 7.0 * std::pow(std::sin(angle(1)), 2) +
                0.1 * std::pow(angle(2), 4) * std::sin(angle(0)));
  }
  const Sensitivity all = sensitivity(x, y, 1);
  const std::vector<double> truth{0.3139, 0.4424, 0.0};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Estimate& share = all.of_quantity[i].variance_share;
    EXPECT_NEAR(share.value, truth[i], 0.03) << i;
    EXPECT_LT(share.low, truth[i] + 0.01) << i;
    EXPECT_GT(share.high, truth[i] - 0.01) << i;
  }
  EXPECT_NEAR(all.of_quantity[1].slope.value().value, 0.0, 0.03);
  EXPECT_LT(all.explained, 0.3);
}

// 40 samples of 200 runs; the interval of a slope misses in 5 % of them: two, and more than eight by a chance of 2e-4.
TEST(Sensitivity, HasIntervalsThatHoldTheTruth) {
  const std::uint32_t seed = test::seed(1);
  int missed = 0;
  for (std::uint64_t sample = 0; sample < 40; ++sample) {
    sim::Random random{seed, sample};
    std::vector<std::vector<double>> x(2);
    std::vector<double> y;
    for (int run = 0; run < 200; ++run) {
      x[0].push_back(random.gaussian());
      x[1].push_back(random.gaussian());
      y.push_back(x[0].back() + 2.0 * random.gaussian());
    }
    const Sensitivity all = sensitivity(x, y, 1);
    const Estimate none = all.of_quantity[1].slope.value();
    missed += none.low > 0.0 || none.high < 0.0 ? 1 : 0;
  }
  EXPECT_LE(missed, 8);
}

}  // namespace
}  // namespace fantail::campaign
