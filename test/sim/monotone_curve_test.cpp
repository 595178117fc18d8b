// SPDX-License-Identifier: MIT
#include "sim/monotone_curve.hpp"

#include <gtest/gtest.h>

namespace fantail::sim {
namespace {

TEST(MonotoneCurve, GoesThroughItsPointsAndIsConstantBeyondThem) {
  const MonotoneCurve curve{{0.0, 0.5, 2.0}, {1.0, 3.0, -2.0}};
  EXPECT_DOUBLE_EQ(curve.at(0.0).value, 1.0);
  EXPECT_DOUBLE_EQ(curve.at(0.5).value, 3.0);
  EXPECT_DOUBLE_EQ(curve.at(2.0).value, -2.0);
  EXPECT_DOUBLE_EQ(curve.at(-7.0).value, 1.0);
  EXPECT_DOUBLE_EQ(curve.at(9.0).value, -2.0);
  EXPECT_DOUBLE_EQ(curve.at(9.0).slope_per_s, 0.0);
}

TEST(MonotoneCurve, OfAStraightLineIsThatLine) {
  const MonotoneCurve curve{{0.0, 0.1, 0.7, 1.0}, {2.0, 2.5, 5.5, 7.0}};
  for (const double t : {0.03, 0.1, 0.4, 0.99}) {
    EXPECT_NEAR(curve.at(t).value, 2.0 + 5.0 * t, 1e-12);
    EXPECT_NEAR(curve.at(t).slope_per_s, 5.0, 1e-12);
    EXPECT_NEAR(curve.at(t).curvature_per_s2, 0.0, 1e-9);
  }
}

TEST(MonotoneCurve, HasNoHumpThatItsPointsDoNotHaveAndNoJumpInItsSlope) {
  const MonotoneCurve curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.0, 0.0, 10.0, 10.0}};
  double before = curve.at(0.0).slope_per_s;
  for (double t = 0.0; t < 4.0; t += 1e-3) {
    const MonotoneCurve::Here here = curve.at(t);
    EXPECT_GE(here.value, 0.0);
    EXPECT_LE(here.value, 10.0);
    EXPECT_NEAR(here.slope_per_s, before, 0.1) << t;  // a cubic from 0 to 10 within a second bends by 60 a second
    before = here.slope_per_s;
  }
}

}  // namespace
}  // namespace fantail::sim
