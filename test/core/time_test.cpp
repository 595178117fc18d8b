// SPDX-License-Identifier: MIT
#include "core/time.hpp"

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

TEST(Time, InstantsAreSubtractedBeforeTheyBecomeFloats) {
  const Microseconds a_day{86'400'000'000};
  EXPECT_FLOAT_EQ(seconds((a_day + Microseconds{1000}) - a_day), 0.001F);
}

}  // namespace
}  // namespace fantail::core
