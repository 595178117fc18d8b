// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "page/heat_map.hpp"

namespace fantail::page {
namespace {

double linear(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }

// CIE 1976 L*, a*, b* of an sRGB colour.
std::array<double, 3> lab(Colour colour) {
  const double r = linear(colour.red / 255.0);
  const double g = linear(colour.green / 255.0);
  const double b = linear(colour.blue / 255.0);
  const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(ColourScale, GetsLighterAllTheWay) {
  for (int i = 0; i < 100; ++i) {
    EXPECT_LT(lab(colour_at(i / 100.0))[0], lab(colour_at((i + 1) / 100.0))[0]) << i;
  }
}

TEST(ColourScale, EqualStepsLookAboutEqual) {
  std::array<double, 16> steps{};
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto a = lab(colour_at(static_cast<double>(i) / 16.0));
    const auto b = lab(colour_at(static_cast<double>(i + 1) / 16.0));
    steps[i] = b[0] - a[0];  // lightness: what is left without colour vision
    sum += steps[i];
  }
  for (const double step : steps) {
    EXPECT_GT(step, 0.6 * sum / 16.0);
    EXPECT_LT(step, 1.4 * sum / 16.0);
  }
}

TEST(ColourScale, OutsideItEndsAreHeld) {
  EXPECT_EQ(colour_at(-3.0), colour_at(0.0));
  EXPECT_EQ(colour_at(7.0), colour_at(1.0));
  EXPECT_NE(colour_at(0.0), colour_at(1.0));
}

}  // namespace
}  // namespace fantail::page
