// SPDX-License-Identifier: MIT
#include "core/angle.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fantail::core {
namespace {

using namespace literals;

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
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(clamp(Angle::from_radians(infinity), 6_deg), 6_deg);
  EXPECT_EQ(clamp(Angle::from_radians(-infinity), 6_deg), -6_deg);
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

}  // namespace
}  // namespace fantail::core
