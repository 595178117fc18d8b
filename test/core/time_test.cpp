// SPDX-License-Identifier: MIT
#include "core/time.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace fantail::core {
namespace {

TEST(Time, SecondsBecomeMicrosecondsWithoutLosingWhatTheirFloatKnows) {
  for (std::int64_t i = 0; i <= 3'600'000; ++i) {
    const auto value_s = static_cast<float>(static_cast<double>(i) * 0.001 + 1e-6 * static_cast<double>(i % 997));
    ASSERT_NEAR(static_cast<double>(from_seconds(value_s).count()), static_cast<double>(value_s) * 1e6, 0.55);
    ASSERT_EQ(millionths(-value_s), -millionths(value_s));
  }
}

TEST(Time, EveryMillisecondOfTheFirstEightSecondsIsExact) {
  for (std::int64_t i = 0; i <= 8000; ++i) {
    ASSERT_EQ(from_seconds(static_cast<float>(static_cast<double>(i) * 0.001)).count(), i * 1000);
  }
}

TEST(Time, DifferencesAreGoodToAMicrosecondBelowSixteenSeconds) {
  for (std::int64_t i = -16'000'000; i <= 16'000'000; i += 997) {
    ASSERT_NEAR(static_cast<double>(seconds(Microseconds{i})), static_cast<double>(i) * 1e-6, 1e-6);
  }
}

TEST(Time, AWideNumberBecomesTheFloatThatTheCompilersOwnConversionMakesOfIt) {
  std::mt19937_64 random{20261124};
  for (int bits = 1; bits <= 64; ++bits) {
    for (int i = 0; i < 300; ++i) {
      // Also those next to the middle between two floats, where what was shifted out decides.
      const auto value =
          static_cast<std::int64_t>(random() >> (64 - bits) & (i % 2 == 0 ? ~0ULL : 0xFFFFFF0000000001ULL));
      for (const std::int64_t each : {value, value ^ -1}) {
        ASSERT_EQ(wide_to_float(each), static_cast<float>(each)) << each;
      }
    }
  }
  for (const std::int64_t end : {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                                 std::int64_t{0}, (std::int64_t{1} << 55) + (std::int64_t{1} << 31)}) {
    ASSERT_EQ(wide_to_float(end), static_cast<float>(end)) << end;
  }
}

TEST(Time, ZeroIsThePositiveOne) { EXPECT_FALSE(std::signbit(wide_to_float(0))); }

TEST(Time, DifferencesOfADayAreSecondsToo) {
  EXPECT_FLOAT_EQ(seconds(Microseconds{86'400'000'000}), 86'400.0F);
  EXPECT_FLOAT_EQ(seconds(Microseconds{-86'400'000'000}), -86'400.0F);
}

TEST(Time, MillionthsAreTheNearestWholeNumber) {
  for (const auto& [value, expected] : {std::pair{0.0F, 0LL},
                                        {1.25F, 1'250'000},
                                        {-1.25F, -1'250'000},
                                        {0.6e-6F, 1},
                                        {0.4e-6F, 0},
                                        {-0.6e-6F, -1},
                                        {-0.4e-6F, 0},
                                        {3'600.0F, 3'600'000'000LL},
                                        {1.4e-6F, 1},
                                        {-1.4e-6F, -1}}) {
    EXPECT_EQ(millionths(value), expected) << value;
  }
  EXPECT_EQ(from_seconds(0.25F), Microseconds{250'000});
}

TEST(Time, ASpanUpToALimitIsNeitherNegativeNorLonger) {
  constexpr Microseconds most{5};
  for (const auto& [span, expected] : {std::pair{-1, 0}, {0, 0}, {1, 1}, {4, 4}, {5, 5}, {6, 5}}) {
    EXPECT_EQ(up_to(most, Microseconds{span}), Microseconds{expected}) << span;
  }
}

TEST(Time, InstantsAreSubtractedBeforeTheyBecomeFloats) {
  const Microseconds a_day{86'400'000'000};
  EXPECT_FLOAT_EQ(seconds((a_day + Microseconds{1000}) - a_day), 0.001F);
}

}  // namespace
}  // namespace fantail::core
