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

TEST(Angle, ArithmeticIsThatOfItsRadians) {
  EXPECT_EQ((2.0_rad - 0.5_rad).radians(), 1.5F);
  EXPECT_EQ((2.0F * 1.5_rad).radians(), 3.0F);
  EXPECT_EQ((3.0_rad / 2.0F).radians(), 1.5F);
  EXPECT_EQ(abs(-2_deg), 2_deg);
  EXPECT_LT(-2_deg, 1_deg);
}

}  // namespace
}  // namespace fantail::core
