// SPDX-License-Identifier: MIT
#include "campaign/unit_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/seed_of_run.hpp"

namespace fantail::campaign {
namespace {

TEST(Seeds, EveryRunHasOneOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t master = 0; master < 20; ++master) {
    for (std::size_t index = 0; index < 500; ++index) {
      seeds.insert(seed_of_run(master, index));
    }
  }
  EXPECT_EQ(seeds.size(), 10000U);
  EXPECT_EQ(seed_of_run(7, 3), seed_of_run(7, 3));
}

// jq, JavaScript and spreadsheets have no other numbers than doubles.
TEST(Seeds, OfRunsComeBackFromADouble) {
  for (const std::uint64_t master : {std::uint64_t{1}, std::uint64_t{7}, std::numeric_limits<std::uint64_t>::max()}) {
    for (std::uint64_t run = 0; run < 1000; ++run) {
      const std::uint64_t seed = seed_of_run(master, run);
      EXPECT_EQ(static_cast<std::uint64_t>(static_cast<double>(seed)), seed);
      EXPECT_LT(seed, std::uint64_t{1} << 53U);
    }
  }
}

// SciPy 1.17, scipy.stats.qmc.Sobol(21, scramble=False), points 5 and 4097.
TEST(UnitPoints, OfSobolsSequenceAreThoseThatSciPyComputes) {
  const std::vector<double> fifth{0.875, 0.875, 0.125, 0.375, 0.875, 0.625, 0.875, 0.375, 0.375, 0.125, 0.375,
                                  0.875, 0.875, 0.125, 0.875, 0.375, 0.875, 0.375, 0.375, 0.625, 0.625};
  const std::vector<double> late{0.5003662109375, 0.9705810546875, 0.3358154296875, 0.1204833984375, 0.6649169921875,
                                 0.0428466796875, 0.2086181640625, 0.3367919921875, 0.1629638671875, 0.4947509765625,
                                 0.3450927734375, 0.6112060546875, 0.0252685546875, 0.8948974609375, 0.1624755859375,
                                 0.7777099609375, 0.6146240234375, 0.0902099609375, 0.5452880859375, 0.9649658203125,
                                 0.1724853515625};
  for (std::size_t dimension = 0; dimension < most_sobol_dimensions; ++dimension) {
    EXPECT_EQ(sobol_coordinate(5, dimension), fifth[dimension]) << dimension;
    EXPECT_EQ(sobol_coordinate(4097, dimension), late[dimension]) << dimension;
  }
}

std::set<std::size_t> strata_met(Sampling sampling, std::size_t runs, std::size_t dimension) {
  const UnitPoints points{sampling, 7, runs};
  std::set<std::size_t> met;
  for (std::size_t run = 0; run < runs; ++run) {
    const double at = points.at(run, dimension);
    EXPECT_GT(at, 0.0);
    EXPECT_LT(at, 1.0);
    met.insert(static_cast<std::size_t>(at * static_cast<double>(runs)));
  }
  return met;
}

TEST(UnitPoints, OfALatinHypercubeMeetEveryStratumOfEveryDimensionOnce) {
  for (const std::size_t runs : {1U, 2U, 3U, 64U, 1000U, 1025U}) {
    for (const std::size_t dimension : {0U, 1U, 40U}) {
      EXPECT_EQ(strata_met(Sampling::latin_hypercube, runs, dimension).size(), runs);
    }
  }
}

TEST(UnitPoints, OfAShiftedSobolSequenceMeetEveryStratumOfAPowerOfTwoOnce) {
  for (std::size_t dimension = 0; dimension < most_sobol_dimensions; ++dimension) {
    EXPECT_EQ(strata_met(Sampling::sobol, 1024, dimension).size(), 1024U) << dimension;
  }
}

TEST(UnitPoints, OfIndependentRunsAreTheSameWithAnyNumberOfRuns) {
  for (std::uint64_t run = 0; run < 100; ++run) {
    EXPECT_EQ((UnitPoints{Sampling::independent, 3, 100}.at(run, 2)),
              (UnitPoints{Sampling::independent, 3, 1'000'000}.at(run, 2)));
  }
}

// The correlation of n pairs of independent even numbers has a standard deviation of n^-1/2: here 0.0032.
TEST(UnitPoints, OfTwoDimensionsDoNotDependOnEachOther) {
  constexpr std::uint64_t runs = 100'000;
  for (const Sampling sampling : {Sampling::independent, Sampling::latin_hypercube, Sampling::sobol}) {
    const UnitPoints points{sampling, 11, runs};
    double sum = 0.0;
    for (std::uint64_t run = 0; run < runs; ++run) {
      sum += (points.at(run, 0) - 0.5) * (points.at(run, 1) - 0.5);
    }
    EXPECT_NEAR(12.0 * sum / static_cast<double>(runs), 0.0, 0.016) << static_cast<int>(sampling);
  }
}

}  // namespace
}  // namespace fantail::campaign
