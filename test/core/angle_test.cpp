// SPDX-License-Identifier: MIT
#include "core/angle.hpp"

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

}  // namespace
}  // namespace fantail::core
