// SPDX-License-Identifier: MIT

#include "core/angle.hpp"
#include "core/finite.hpp"
#include "core/time.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;
using Limits = std::numeric_limits<float>;

TEST(Angle, DegreesAndRadiansNameTheSameAngle) {
  EXPECT_FLOAT_EQ((180_deg).radians(), 3.14159265F);
  EXPECT_FLOAT_EQ((1.0_rad).degrees(), 57.2957795F);
}

TEST(Angle, IsNeverWrapped) { EXPECT_FLOAT_EQ((360_deg + 360_deg).degrees(), 720.0F); }

TEST(Angle, ClampKeepsWhatLiesInsideAndStopsAtBothLimits) {
  EXPECT_EQ(clamp(5_deg, 6_deg), 5_deg);
  EXPECT_EQ(clamp(7_deg, 6_deg), 6_deg);
  EXPECT_EQ(clamp(-7_deg, 6_deg), -6_deg);
}

TEST(Angle, ClampAcceptsTheLimitsThemselvesAndALimitOfZero) {
  EXPECT_EQ(clamp(6_deg, 6_deg), 6_deg);
  EXPECT_EQ(clamp(-6_deg, 6_deg), -6_deg);
  EXPECT_EQ(clamp(1_deg, 0_deg), 0_deg);
  EXPECT_EQ(clamp(-1_deg, 0_deg), 0_deg);
}

TEST(Angle, ClampStopsInfinitiesAndLetsANotANumberBeSeen) {
  EXPECT_EQ(clamp(Angle::from_radians(Limits::infinity()), 6_deg), 6_deg);
  EXPECT_EQ(clamp(Angle::from_radians(-Limits::infinity()), 6_deg), -6_deg);
  EXPECT_TRUE(std::isnan(clamp(Angle::from_radians(std::numeric_limits<float>::quiet_NaN()), 6_deg).radians()));
}

TEST(Angle, ClampToARangeKeepsWhatLiesInsideAndStopsAtBothEnds) {
  const AngleRange range{.lowest = -2_deg, .highest = 5_deg};
  EXPECT_EQ(clamp(-3_deg, range), -2_deg);
  EXPECT_EQ(clamp(-1_deg, range), -1_deg);
  EXPECT_EQ(clamp(4_deg, range), 4_deg);
  EXPECT_EQ(clamp(6_deg, range), 5_deg);
}

// A replay compares bits, and a zero has two.
TEST(Angle, ClampLeavesWhatLiesOnTheLimitAsItIsToTheSignOfAZero) {
  const Angle zero = Angle::from_radians(0.0F);
  const Angle negative_zero = Angle::from_radians(-0.0F);
  EXPECT_FALSE(std::signbit(clamp(zero, zero).radians()));
  EXPECT_TRUE(std::signbit(clamp(negative_zero, AngleRange{.lowest = zero, .highest = 1_deg}).radians()));
  EXPECT_TRUE(std::signbit(clamp(negative_zero, AngleRange{.lowest = -1_deg, .highest = zero}).radians()));
}

TEST(Angle, EveryComparisonTellsSmallerEqualAndGreaterApart) {
  const Angle small = 1_deg;
  const Angle large = 2_deg;
  EXPECT_TRUE(small < large && !(small < small) && !(large < small));
  EXPECT_TRUE(small <= large && small <= small && !(large <= small));
  EXPECT_TRUE(large > small && !(small > small) && !(small > large));
  EXPECT_TRUE(large >= small && small >= small && !(small >= large));
  EXPECT_TRUE(small == small && !(small == large));
}

TEST(Angle, ArithmeticIsThatOfItsRadians) {
  EXPECT_EQ((2.0_rad - 0.5_rad).radians(), 1.5F);
  EXPECT_EQ((2.0F * 1.5_rad).radians(), 3.0F);
  EXPECT_EQ((3.0_rad / 2.0F).radians(), 1.5F);
  EXPECT_EQ((0.5_rad + 0.25_rad).radians(), 0.75F);
  EXPECT_EQ((-(0.5_rad)).radians(), -0.5F);
  Angle sum = 0.5_rad;
  sum += 0.25_rad;
  EXPECT_EQ(sum.radians(), 0.75F);
  EXPECT_EQ(Angle{}.radians(), 0.0F);
  EXPECT_EQ(abs(-2_deg), 2_deg);
  EXPECT_LT(-2_deg, 1_deg);
}

TEST(Finite, IsEveryNumberAndNothingElse) {
  for (const float number : {0.0F, -0.0F, Limits::denorm_min(), Limits::min(), Limits::max(), Limits::lowest()}) {
    EXPECT_TRUE(is_finite(number)) << number;
  }
  for (const float other : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()}) {
    EXPECT_FALSE(is_finite(other)) << other;
  }
}

TEST(Finite, OneBadComponentSpoilsAVector) {
  EXPECT_TRUE(is_finite(Vector3{1.0F, 2.0F, 3.0F}));
  EXPECT_FALSE(is_finite(Vector3{Limits::quiet_NaN(), 0.0F, 0.0F}));
  EXPECT_FALSE(is_finite(Vector3{0.0F, Limits::infinity(), 0.0F}));
  EXPECT_FALSE(is_finite(Vector3{0.0F, 0.0F, -Limits::infinity()}));
}

TEST(Finite, TheLimitItselfIsWithinItAndTheNextNumberIsNot) {
  constexpr float most = 2.5F;
  const float beyond = std::nextafter(most, Limits::infinity());
  for (const float sense : {1.0F, -1.0F}) {
    EXPECT_TRUE(is_within(sense * most, most));
    EXPECT_FALSE(is_within(sense * beyond, most));
    EXPECT_TRUE(is_within(Vector3{sense * most, -sense * most, sense * most}, most));
    EXPECT_FALSE(is_within(Vector3{sense * beyond, 0.0F, 0.0F}, most));
    EXPECT_FALSE(is_within(Vector3{0.0F, sense * beyond, 0.0F}, most));
    EXPECT_FALSE(is_within(Vector3{0.0F, 0.0F, sense * beyond}, most));
  }
  EXPECT_FALSE(is_within(Limits::quiet_NaN(), most));
}

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
