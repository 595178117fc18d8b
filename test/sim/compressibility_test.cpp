// SPDX-License-Identifier: MIT
#include "sim/compressibility.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/drag_over_mach.hpp"

namespace fantail::sim {
namespace {

TEST(Compressibility, IsThePrandtlGlauertFactorUpToMach08AndIsHeldAbove) {
  const auto factor = [](double mach) { return compressibility_factor(Compressibility::prandtl_glauert, mach); };
  EXPECT_EQ(factor(0.0), 1.0);
  EXPECT_NEAR(factor(0.5), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(factor(-0.5), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(factor(0.6), 1.25, 1e-15);
  EXPECT_NEAR(factor(0.8), 5.0 / 3.0, 1e-15);
  for (const double mach : {0.81, 1.0, 3.0, -1.0}) {
    EXPECT_EQ(factor(mach), factor(0.8)) << mach;
  }
}

TEST(Compressibility, IsOneWhereThereIsNone) { EXPECT_EQ(compressibility_factor(Compressibility::none, 0.7), 1.0); }

TEST(DragOverMach, IsLinearBetweenItsPointsAndHeldAtItsEnds) {
  const DragOverMach drag{.mach = {0.3, 0.8, 1.0}, .factor = {1.0, 1.2, 2.0}};
  EXPECT_EQ(drag.at(0.0), 1.0);
  EXPECT_EQ(drag.at(0.3), 1.0);
  EXPECT_NEAR(drag.at(0.55), 1.1, 1e-15);
  EXPECT_NEAR(drag.at(0.95), 1.8, 1e-15);
  EXPECT_EQ(drag.at(0.8), 1.2);
  EXPECT_EQ(drag.at(1.0), 2.0);
  EXPECT_EQ(drag.at(5.0), 2.0);
}

TEST(DragOverMach, OfOnePointIsAFactorAndOfNoneIsOne) {
  EXPECT_EQ((DragOverMach{.mach = {0.5}, .factor = {1.3}}).at(0.1), 1.3);
  EXPECT_EQ((DragOverMach{.mach = {0.5}, .factor = {1.3}}).at(0.9), 1.3);
  EXPECT_EQ(DragOverMach{}.at(0.9), 1.0);
  EXPECT_FALSE(DragOverMach{}.is_there());
}

}  // namespace
}  // namespace fantail::sim
