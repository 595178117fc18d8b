// SPDX-License-Identifier: MIT
#include "sim/random.hpp"

#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr std::uint64_t first_seed = 20160623;
constexpr std::size_t many = 4'000'000;

std::vector<double> gaussians(Random random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) {
    value = random.gaussian();
  }
  return values;
}

double normal_share_below(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

TEST(Random, GivesThePublishedOutputsOfItsGenerator) {
  Random random{std::array<std::uint64_t, 4>{1, 2, 3, 4}};
  for (const std::uint64_t expected :
       {41943041UL, 58720359UL, 3588806011781223UL, 3591011842654386UL, 9228616714210784205UL, 9973669472204895162UL,
        14011001112246962877UL, 12406186145184390807UL, 15849039046786891736UL, 10450023813501588000UL}) {
    EXPECT_EQ(random.bits(), expected);
  }
}

TEST(Random, IsRepeatedBySeedAndStreamAndChangedByEither) {
  Random first{first_seed, 3};
  Random again{first_seed, 3};
  Random other_stream{first_seed, 4};
  Random other_seed{first_seed + 1, 3};
  Random swapped{3, first_seed};
  const std::uint64_t bits = first.bits();
  EXPECT_EQ(again.bits(), bits);
  EXPECT_NE(other_stream.bits(), bits);
  EXPECT_NE(other_seed.bits(), bits);
  EXPECT_NE(swapped.bits(), bits);
  EXPECT_EQ(first.gaussian(), again.gaussian());
}

TEST(Random, UniformFillsItsRangeEvenly) {
  Random random{first_seed, 0};
  std::array<double, 64> bins{};
  for (std::size_t i = 0; i < many; ++i) {
    const double value = random.uniform();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    bins[static_cast<std::size_t>(value * 64.0)] += 1.0;
  }
  double chi_squared = 0.0;
  const double expected = static_cast<double>(many) / 64.0;
  for (const double bin : bins) {
    chi_squared += (bin - expected) * (bin - expected) / expected;
  }
  // 63 degrees of freedom: mean 63, standard deviation 11.2.
  EXPECT_GT(chi_squared, 63.0 - 4.0 * 11.2);
  EXPECT_LT(chi_squared, 63.0 + 4.0 * 11.2);
}

TEST(Random, GaussianHasTheMomentsOfTheNormalDistribution) {
  double sum1 = 0.0;
  double sum2 = 0.0;
  double sum3 = 0.0;
  double sum4 = 0.0;
  for (const double x : gaussians({first_seed, 1}, many)) {
    sum1 += x;
    sum2 += x * x;
    sum3 += x * x * x;
    sum4 += x * x * x * x;
  }
  // Four standard deviations of each moment's own scatter: of x^n it is sqrt((E x^2n - (E x^n)^2) / N).
  const double n = static_cast<double>(many);
  EXPECT_NEAR(sum1 / n, 0.0, 4.0 * std::sqrt(1.0 / n));
  EXPECT_NEAR(sum2 / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(sum3 / n, 0.0, 4.0 * std::sqrt(15.0 / n));
  EXPECT_NEAR(sum4 / n, 3.0, 4.0 * std::sqrt(96.0 / n));
}

TEST(Random, GaussianFollowsTheNormalDistributionIntoTheTails) {
  std::vector<double> values = gaussians({first_seed, 2}, many);
  std::ranges::sort(values);
  // 3.654 is where the lowest box ends and the tail begins.
  for (const double x : {-4.5, -4.0, -3.8, -3.66, -3.6, -3.0, -2.5, -2.0, -1.5, -1.0, -0.5, -0.2, 0.0,
                         0.2,  0.5,  1.0,  1.5,   2.0,  2.5,  3.0,  3.6,  3.66, 3.8,  4.0,  4.5}) {
    const auto below = std::ranges::lower_bound(values, x) - values.begin();
    const double expected = normal_share_below(x);
    const double scatter = std::sqrt(expected * (1.0 - expected) / static_cast<double>(many));
    EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(many), expected, 4.0 * scatter) << x;
  }
  EXPECT_GT(values.back(), 4.6);  // the tail is not cut: one in 470 000 lies beyond
  EXPECT_LT(values.front(), -4.6);
}

TEST(Random, SeveralGaussiansAtOnceAreNormalInEveryPlace) {
  Random random{first_seed, 7};
  std::array<double, 5> sums{};
  std::array<double, 5> squares{};
  double neighbours = 0.0;
  constexpr std::size_t rounds = 500'000;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::array<double, 5> values = random.gaussians<5>();
    for (std::size_t i = 0; i < values.size(); ++i) {
      sums[i] += values[i];
      squares[i] += values[i] * values[i];
    }
    neighbours += values[0] * values[1];  // both halves of one word
  }
  const double n = static_cast<double>(rounds);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_NEAR(sums[i] / n, 0.0, 4.0 / std::sqrt(n));
    EXPECT_NEAR(squares[i] / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  }
  EXPECT_NEAR(neighbours / n, 0.0, 4.0 / std::sqrt(n));
}

TEST(Random, StreamsAndNeighbouringSeedsDoNotCorrelate) {
  constexpr std::size_t count = 500'000;
  const std::vector<double> reference = gaussians({first_seed, 0}, count);
  const Random others[] = {{first_seed, 1},     {first_seed, 2},     {first_seed, 1ULL << 63U},
                           {first_seed + 1, 0}, {first_seed + 1, 1}, {0, 0}};
  for (const Random& other : others) {
    const std::vector<double> values = gaussians(other, count);
    for (const std::size_t shift : {0U, 1U, 2U}) {
      double product = 0.0;
      for (std::size_t i = shift; i < count; ++i) {
        product += reference[i] * values[i - shift];
      }
      EXPECT_NEAR(product / static_cast<double>(count), 0.0, 4.0 / std::sqrt(static_cast<double>(count)));
    }
  }
}

TEST(Ziggurat, AllLayersHaveTheSameAreaAndTheTopOneEndsAtTheSummit) {
  const double last_edge = ziggurat.layer[0].inner_edge;
  const double tail = std::sqrt(std::numbers::pi / 2.0) * std::erfc(last_edge / std::numbers::sqrt2);
  const double area = last_edge * std::exp(-0.5 * last_edge * last_edge) + tail;
  for (std::size_t i = 0; i < Ziggurat::layers; ++i) {
    const double edge = ziggurat.layer[i].edge_per_step * 0x1p24;
    const double inner = ziggurat.layer[i].inner_edge;
    EXPECT_NEAR(edge * (ziggurat.height[i + 1] - ziggurat.height[i]), area, 1e-13) << i;
    EXPECT_NEAR(std::exp(-0.5 * inner * inner), ziggurat.height[i + 1], 1e-15) << i;
  }
  EXPECT_EQ(ziggurat.height.back(), 1.0);
}

}  // namespace
}  // namespace fantail::sim
