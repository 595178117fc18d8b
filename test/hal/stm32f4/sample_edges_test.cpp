// SPDX-License-Identifier: MIT
#include "hal/stm32f4/sample_edges.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace fantail::hal::stm32f4 {
namespace {

/// Samples of a device with this period; how many of them were believed to have come at their edges.
int believed(SampleEdges& edges, double period_us, int samples, std::uint32_t begin = 1'000'000) {
  int count = 0;
  for (int i = 1; i <= samples; ++i) {
    count += edges.take(begin + static_cast<std::uint32_t>(std::lround(period_us * i)), false) ? 1 : 0;
  }
  return count;
}

TEST(SampleEdges, AreBelievedFromTheTenthOnWhateverTheDevicesOscillatorDoes) {
  for (const double period_us : {965.0, 990.0, 1000.0, 1010.0, 1035.0}) {  // 1.5 % and 2 %
    SampleEdges edges;
    EXPECT_EQ(believed(edges, period_us, 1000), 990) << period_us;
    EXPECT_FALSE(edges.lost());
  }
}

TEST(SampleEdges, TheWrapOfTheCounterIsNone) {
  SampleEdges edges;
  EXPECT_EQ(believed(edges, 1010.0, 1000, 0xFFFF'FFFF - 500'000), 990);
}

TEST(SampleEdges, ASampleThatWasNeverReadIsNoMisfit) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 990.0, 20));
  EXPECT_TRUE(edges.take(1'000'000 + 22 * 990, true));
  EXPECT_TRUE(edges.take(1'000'000 + 26 * 990, true));
}

TEST(SampleEdges, WithoutAWireNoneIsBelievedAndAfterAHundredSamplesItIsLost) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(edges.lost());
    EXPECT_FALSE(edges.take(1'100'000, false));
  }
  for (int i = 0; i < 3; ++i) {  // of the twenty that fitted, two misfits leave ten
    EXPECT_FALSE(edges.take(1'100'000, false));
  }
  EXPECT_TRUE(edges.lost());
  EXPECT_GE(believed(edges, 1000.0, 100), 89) << "and it comes back";
  EXPECT_FALSE(edges.lost());
}

TEST(SampleEdges, ALineThatFloatsIsNotBelieved) {
  std::mt19937 random{1};
  std::uniform_int_distribution<std::uint32_t> when{0, 999};
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  int count = 0;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    count += edges.take(2'000'000 + 1000 * i + when(random), i % 2 == 0) ? 1 : 0;
  }
  EXPECT_LE(count, 3) << "in 100 s, before it was found out";
  EXPECT_TRUE(edges.lost());
}

TEST(SampleEdges, ALineWithThousandsOfEdgesIsNotBelievedThoughTheLatestIsAlwaysATickBehindTheLast) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  for (std::uint32_t i = 0; i < 200; ++i) {
    EXPECT_FALSE(edges.take(2'000'000 + 1000 * i, true));
  }
  EXPECT_TRUE(edges.lost());
}

TEST(SampleEdges, ASpikeCostsTwoSamplesTheirTimesAndNotTheLine) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 50));
  EXPECT_FALSE(edges.take(1'051'300, true));
  EXPECT_FALSE(edges.take(1'052'000, false));
  EXPECT_TRUE(edges.take(1'053'000, false));
}

}  // namespace
}  // namespace fantail::hal::stm32f4
