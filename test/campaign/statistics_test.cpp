// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/analysis.hpp"
#include "campaign/stop_rule.hpp"
#include "distributions/quantiles.hpp"
#include "seed.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

/// Even points, one list a quantity: multiples of roots that no whole numbers relate, without what is before the point.
std::vector<std::vector<double>> even_points(std::uint64_t runs) {
  std::vector<std::vector<double>> all;
  for (const double root : {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)}) {
    std::vector<double>& list = all.emplace_back();
    for (std::uint64_t run = 0; run < runs; ++run) {
      list.push_back(std::fmod(root * static_cast<double>(run), 1.0));
    }
  }
  return all;
}

// y = 3 a - 4 b + c with even quantities of the same width: slopes 3, -4 and 1 over sqrt(26).
TEST(Sensitivity, OfStraightLinesIsTheirClosedForm) {
  constexpr std::uint64_t runs = 4096;
  const auto x = even_points(runs);
  std::vector<double> y;
  for (std::size_t run = 0; run < runs; ++run) {
    y.push_back(7.0 + 3.0 * x[0][run] - 4.0 * x[1][run] + x[2][run]);
  }
  const Sensitivity all = sensitivity(x, y);
  EXPECT_NEAR(all.explained, 1.0, 1e-12);
  const double root = std::sqrt(26.0);
  EXPECT_NEAR(all.slopes[0].value().value, 3.0 / root, 2e-3);
  EXPECT_NEAR(all.slopes[1].value().value, -4.0 / root, 2e-3);
  EXPECT_NEAR(all.slopes[2].value().value, 1.0 / root, 2e-3);
}

// Against slopes that were computed anew without each run.
TEST(Sensitivity, LeavesOutEachRunAsIfItHadNotBeenFlown) {
  const std::uint32_t seed = test::seed(1);
  sim::Random random{seed, 0};
  std::vector<std::vector<double>> x(2);
  std::vector<double> y;
  constexpr std::size_t runs = 40;
  for (std::size_t run = 0; run < runs; ++run) {
    x[0].push_back(3.0 + random.gaussian());
    x[1].push_back(x[0].back() + 5.0 * random.gaussian());
    y.push_back(x[0].back() + std::pow(x[1].back(), 2));
  }
  const Estimate slope = sensitivity(x, y).slopes[0].value();
  std::vector<double> without;
  for (std::size_t left_out = 0; left_out < runs; ++left_out) {
    const auto rest = [left_out](std::vector<double> values) {
      values.erase(values.begin() + static_cast<std::ptrdiff_t>(left_out));
      return values;
    };
    without.push_back(sensitivity({rest(x[0]), rest(x[1])}, rest(y)).slopes[0].value().value);
  }
  double mean = 0.0;
  for (const double value : without) {
    mean += value / runs;
  }
  double squares = 0.0;
  double fourth = 0.0;
  for (const double value : without) {
    squares += std::pow(value - mean, 2);
    fourth += std::pow(value - mean, 4);
  }
  const double kurtosis = runs * fourth / (squares * squares);
  const double quantile = distributions::student_975(2.0 * runs / (1.5 * (kurtosis - 1.0)));
  EXPECT_NEAR(slope.high - slope.value, quantile * std::sqrt((runs - 1.0) / runs * squares), 1e-9);
  EXPECT_NEAR(slope.value - slope.low, slope.high - slope.value, 1e-12);
}

// Thirty runs in which one alone has another value: without it that quantity says nothing.
TEST(Sensitivity, GivesNoSlopeThatOneRunDecidesOrThatAnotherQuantityHolds) {
  std::vector<double> once(30, 0.0);
  once[4] = 1.0;
  std::vector<double> count;
  std::vector<double> twice;
  std::vector<double> y;
  for (int run = 0; run < 30; ++run) {
    count.push_back(run);
    twice.push_back(2.0 * run);
    y.push_back(run % 7);
  }
  EXPECT_FALSE(sensitivity({once, count}, y).slopes[0]);
  EXPECT_FALSE(sensitivity({twice, count}, y).slopes[0]);
  EXPECT_FALSE(sensitivity({twice, count}, y).slopes[1]);
}

}  // namespace
}  // namespace fantail::campaign
