// SPDX-License-Identifier: MIT
#include "tunnel/statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tunnel/made_logs.hpp"

namespace fantail::tunnel {
namespace {

TEST(Moments, AreThoseOfASample) {
  const std::vector<double> values{1.0, 2.0, 3.0, 6.0};
  EXPECT_DOUBLE_EQ(moments(values).mean, 3.0);
  EXPECT_DOUBLE_EQ(moments(values).standard_deviation, std::sqrt(14.0 / 3.0));
}

TEST(KnownMean, ConstantSamplesHaveNoError) {
  const KnownMean known = known_mean(std::vector<double>(10, 22.0));
  EXPECT_EQ(known.mean, 22.0);
  EXPECT_EQ(known.standard_error, 0.0);
}

// Over many records the means scatter as much as each record says of its own: without memory as a root of the number of
// samples, with a memory of r from sample to sample by another factor of sqrt((1 + r) / (1 - r)).
TEST(KnownMean, ItsErrorIsHowMuchTheMeansOfManyRecordsScatter) {
  const std::uint64_t seed = 4;
  for (const double memory : {0.0, 0.6, 0.95}) {
    Gaussian gaussian{seed};
    constexpr int records = 400;
    constexpr int samples = 3000;
    double said = 0.0;
    double squares = 0.0;
    for (int i = 0; i < records; ++i) {
      std::vector<double> values;
      double value = gaussian();
      for (int j = 0; j < samples; ++j) {
        value = memory * value + std::sqrt(1.0 - memory * memory) * gaussian();
        values.push_back(5.0 + value);
      }
      const KnownMean known = known_mean(values);
      said += known.standard_error / records;
      squares += (known.mean - 5.0) * (known.mean - 5.0) / records;
    }
    const double truth = std::sqrt((1.0 + memory) / (1.0 - memory) / samples);
    EXPECT_NEAR(said, truth, 0.12 * truth) << "memory " << memory << " seed " << seed;
    EXPECT_NEAR(std::sqrt(squares), truth, 0.12 * truth) << "memory " << memory << " seed " << seed;
  }
}

// 50 Hz samples of something that changes slowly are averaged in blocks first.
TEST(KnownMean, AveragingInBlocksLeavesTheErrorAsItIs) {
  const std::uint64_t seed = 5;
  Gaussian gaussian{seed};
  std::vector<double> few;
  std::vector<double> many;
  double value = 0.0;
  for (int i = 0; i < 1500; ++i) {
    value = 0.8 * value + 0.6 * gaussian();
    few.push_back(value);
    many.insert(many.end(), 20, value);
  }
  EXPECT_NEAR(known_mean(many).standard_error, known_mean(few).standard_error, 0.1 * known_mean(few).standard_error)
      << "seed " << seed;
}

TEST(FitLine, FindsALineAndHowMuchOfTheScatterItExplains) {
  const Line exact = fit_line(std::vector<double>{1.0, 2.0, 4.0}, std::vector<double>{5.0, 7.0, 11.0});
  EXPECT_NEAR(exact.slope, 2.0, 1e-12);
  EXPECT_NEAR(exact.offset, 3.0, 1e-12);
  EXPECT_NEAR(exact.r_squared, 1.0, 1e-12);
  // By hand: slope 1/2, offset 5/6, R2 = 3/4.
  const Line loose = fit_line(std::vector<double>{0.0, 1.0, 2.0}, std::vector<double>{1.0, 1.0, 2.0});
  EXPECT_NEAR(loose.slope, 0.5, 1e-12);
  EXPECT_NEAR(loose.offset, 5.0 / 6.0, 1e-12);
  EXPECT_NEAR(loose.r_squared, 0.75, 1e-12);
}

}  // namespace
}  // namespace fantail::tunnel
