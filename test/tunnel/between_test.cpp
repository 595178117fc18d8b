// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "seed.hpp"
#include "tunnel/made_logs.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

TEST(BetweenValues, TakesTheVarianceOfMeasurementOff) {
  const Between b = between_values(std::vector{13.0, 22.0, 25.0}, std::vector{1.0, 2.0, 4.0});
  EXPECT_DOUBLE_EQ(b.seen, std::sqrt(39.0));
  EXPECT_DOUBLE_EQ(b.measurement, std::sqrt(7.0));
  EXPECT_DOUBLE_EQ(b.between, std::sqrt(32.0));
  EXPECT_NEAR(b.low, std::sqrt(2.0 * 39.0 / 7.37776 - 7.0), 1e-4);
  EXPECT_NEAR(b.high, std::sqrt(2.0 * 39.0 / 0.0506356 - 7.0), 1e-3);
}

TEST(BetweenValues, IsNeverBelowZeroAndALuckyRunDoesNotProveThatNothingVaries) {
  const Between b = between_values(std::vector{1.0, 2.0, 3.0}, std::vector{5.0, 5.0, 5.0});
  EXPECT_EQ(b.between, 0.0);
  EXPECT_EQ(b.low, 0.0);
  EXPECT_NEAR(b.high, 5.0 * std::sqrt(2.0 / 0.0506356 - 1.0), 1e-3);
}

// The interval promises 95 %, whatever share of the scatter is measurement.
TEST(BetweenValues, ItsIntervalHoldsTheTruthInNineteenOfTwentyOrMore) {
  const std::uint32_t seed = test::seed(95);
  Gaussian gaussian{seed};
  constexpr int trials = 4000;
  for (const double truth : {0.1, 0.5, 2.0}) {
    int held = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> values;
      std::vector<double> errors;
      for (int step = 0; step < 8; ++step) {
        errors.push_back(step % 2 == 0 ? 0.4 : 0.6);
        values.push_back(19.0 + truth * gaussian() + errors.back() * gaussian());
      }
      const Between b = between_values(values, errors);
      held += b.low <= truth && truth <= b.high ? 1 : 0;
    }
    EXPECT_GT(held, 0.94 * trials) << "truth " << truth << " seed " << seed;
    EXPECT_LT(held, (truth < 1.0 ? 0.985 : 0.96) * trials) << "truth " << truth << " seed " << seed;
  }
}

}  // namespace
}  // namespace fantail::tunnel
