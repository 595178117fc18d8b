// SPDX-License-Identifier: MIT
#include "avionics/mounting.hpp"

#include <array>
#include <set>

#include <gtest/gtest.h>

namespace fantail::avionics {
namespace {

using core::SensorAxis;
using enum SensorAxis;
using hal::Counts;

TEST(Mounting, TurnsTheSensorsAxesIntoTheRockets) {
  // The sensor's y to the nose, its x to the rocket's -y.
  constexpr Mounting mounting{{.to_nose = plus_y, .along_y = minus_x}};
  EXPECT_EQ(mounting.turned({1, 2, 3}), (Counts{2, -1, 3}));
}

TEST(Mounting, FullScaleStaysFullScaleWhenItsSignChanges) {
  constexpr Mounting mounting{{.to_nose = minus_x, .along_y = minus_y}};
  EXPECT_EQ(mounting.turned({32767, -32768, 7}), (Counts{-32768, 32767, 7}));
  EXPECT_EQ(mounting.turned({-32767, 32766, 7}), (Counts{32767, -32766, 7}));
}

TEST(Mounting, NothingToBeUsedStaysNothingToBeUsed) {
  constexpr Mounting mounting{{.to_nose = minus_x, .along_y = minus_y}};
  EXPECT_EQ(mounting.turned(hal::no_counts), hal::no_counts);
}

TEST(Mounting, HasTwentyFourWaysToSitAndNeverMirrors) {
  // A cube can be put down on six faces and turned to four sides. What is turned keeps its handedness: with the images
  // of the sensor's x, y and z as columns the determinant is 1.
  std::set<Counts> seen;
  constexpr std::array axes{plus_x, minus_x, plus_y, minus_y, plus_z, minus_z};
  for (const SensorAxis to_nose : axes) {
    for (const SensorAxis along_y : axes) {
      if (static_cast<int>(to_nose) / 2 == static_cast<int>(along_y) / 2) {
        continue;  // no plan may say so
      }
      const Mounting mounting{{.to_nose = to_nose, .along_y = along_y}};
      const Counts a = mounting.turned({1, 0, 0});
      const Counts b = mounting.turned({0, 1, 0});
      const Counts c = mounting.turned({0, 0, 1});
      EXPECT_EQ(
          a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]),
          1);
      seen.insert(mounting.turned({1, 2, 3}));
    }
  }
  EXPECT_EQ(seen.size(), 24U);
}

}  // namespace
}  // namespace fantail::avionics
