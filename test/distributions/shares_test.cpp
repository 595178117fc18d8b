// SPDX-License-Identifier: MIT
#include "distributions/shares.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "seed.hpp"
#include "sim/random.hpp"

namespace fantail::distributions {
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

TEST(UpperBound, OfNoneIsThreeOverTheNumber) {
  EXPECT_NEAR(upper_bound_95(0, 100'000), 1.0 - std::pow(0.05, 1e-5), 1e-15);
  EXPECT_NEAR(upper_bound_95(0, 1'000'000) * 1e6, 2.9957, 1e-3);
  EXPECT_EQ(upper_bound_95(0, 0), 1.0);
  EXPECT_EQ(upper_bound_95(7, 7), 1.0);
}

/// The probability of at most `count`.
double binomial(int count, int of, double p) {
  double sum = 0.0;
  for (int k = 0; k <= count; ++k) {
    sum += std::exp(std::lgamma(of + 1.0) - std::lgamma(k + 1.0) - std::lgamma(of - k + 1.0) + k * std::log(p) +
                    (of - k) * std::log1p(-p));
  }
  return sum;
}

TEST(UpperBound, IsWhereSoFewComeInOneOfTwentyCampaigns) {
  for (const auto& [count, of] : {std::pair{1, 10}, {1, 1000}, {5, 20}, {19, 20}, {37, 5000}, {400, 500}}) {
    const double bound = upper_bound_95(static_cast<std::uint64_t>(count), static_cast<std::uint64_t>(of));
    EXPECT_NEAR(binomial(count, of, bound), 0.05, 1e-9) << count << " of " << of;
  }
}

}  // namespace
}  // namespace fantail::distributions
