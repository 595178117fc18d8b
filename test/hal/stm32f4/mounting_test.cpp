// SPDX-License-Identifier: MIT
#include "hal/stm32f4/mounting.hpp"

#include <gtest/gtest.h>

namespace fantail::hal::stm32f4 {
namespace {

using enum SensorAxis;

TEST(Mounting, TurnsTheSensorsAxesIntoTheRockets) {
  // The sensor's y to the nose, its x to the rocket's -y.
  constexpr Mounting mounting{plus_y, minus_x, plus_z};
  EXPECT_EQ(mounting.turned({1, 2, 3}), (Counts{2, -1, 3}));
}

TEST(Mounting, FullScaleStaysFullScaleWhenItsSignChanges) {
  constexpr Mounting mounting{minus_x, minus_y, plus_z};
  EXPECT_EQ(mounting.turned({32767, -32768, 7}), (Counts{-32768, 32767, 7}));
  EXPECT_EQ(mounting.turned({-32767, 32766, 7}), (Counts{32767, -32766, 7}));
}

TEST(Mounting, OfAllWaysToNameThreeAxesTwentyFourAreRotations) {
  // A cube can be put down on six faces and turned to four sides.
  int rotations = 0;
  constexpr std::array axes{plus_x, minus_x, plus_y, minus_y, plus_z, minus_z};
  const auto vector = [](SensorAxis axis) {
    std::array<int, 3> v{};
    v[static_cast<std::size_t>(axis) / 2] = static_cast<std::size_t>(axis) % 2 == 0 ? 1 : -1;
    return v;
  };
  for (const SensorAxis x : axes) {
    for (const SensorAxis y : axes) {
      for (const SensorAxis z : axes) {
        const auto a = vector(x);
        const auto b = vector(y);
        const auto c = vector(z);
        const int determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                a[2] * (b[0] * c[1] - b[1] * c[0]);
        EXPECT_EQ(Mounting::is_rotation({x, y, z}), determinant == 1);
        rotations += Mounting::is_rotation({x, y, z}) ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(rotations, 24);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
