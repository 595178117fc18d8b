// SPDX-License-Identifier: MIT
#include "plot/colour_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fantail::plot {
namespace {

// Nine points of "viridis" (public domain), which was made for even steps to the eye; straight between them.
constexpr std::array<Colour, 9> points{{{0x44, 0x01, 0x54},
                                        {0x47, 0x2d, 0x7b},
                                        {0x3b, 0x52, 0x8b},
                                        {0x2c, 0x72, 0x8e},
                                        {0x21, 0x90, 0x8c},
                                        {0x27, 0xad, 0x81},
                                        {0x5d, 0xc8, 0x63},
                                        {0xaa, 0xdc, 0x32},
                                        {0xfd, 0xe7, 0x25}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double part) {
  return static_cast<std::uint8_t>(std::lround(a + part * (static_cast<double>(b) - a)));
}

}  // namespace

Colour colour_at(double part) {
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double rest = place - static_cast<double>(i);
  return {between(points[i].red, points[i + 1].red, rest), between(points[i].green, points[i + 1].green, rest),
          between(points[i].blue, points[i + 1].blue, rest)};
}

}  // namespace fantail::plot
