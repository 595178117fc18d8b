// SPDX-License-Identifier: MIT
#include "sim/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace fantail::sim {

SineCosine sine_cosine(double angle_rad) {
  // To the nearest quarter of a turn; a quarter in two parts, of which the first times any small integer is exact.
  constexpr double quarter = 0.5 * std::numbers::pi;
  constexpr double quarter_high = 0x1.921fb54400000p+0;
  constexpr double quarter_low = 0x1.0b4611a626331p-34;
  const auto quarters = static_cast<std::int64_t>(angle_rad / quarter + (angle_rad < 0.0 ? -0.5 : 0.5));
  const auto n = static_cast<double>(quarters);
  const double x = (angle_rad - n * quarter_high) - n * quarter_low;
  // Taylor; below an eighth of a turn the first terms left out are under 2e-17.
  const double s = x * x;
  const double sine =
      x *
      (1.0 -
       s / 6.0 *
           (1.0 - s / 20.0 *
                      (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0 * (1.0 - s / 156.0 * (1.0 - s / 210.0)))))));
  const double cosine =
      1.0 -
      s / 2.0 *
          (1.0 -
           s / 12.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0 * (1.0 - s / 132.0 * (1.0 - s / 182.0))))));
  switch (quarters & 3) {
    case 0: return {.sine = sine, .cosine = cosine};
    case 1: return {.sine = cosine, .cosine = -sine};
    case 2: return {.sine = -sine, .cosine = -cosine};
    default: return {.sine = -cosine, .cosine = sine};
  }
}

double angle_off(double along, double across) {
  const double longer = std::max(std::abs(along), across);
  if (longer == 0.0) {
    return 0.0;
  }
  // The tangent of the smaller angle, halved twice: t / (1 + sqrt(1 + t^2)). Below 0.199 the series is short.
  double tangent = std::min(std::abs(along), across) / longer;
  tangent = tangent / (1.0 + std::sqrt(1.0 + tangent * tangent));
  tangent = tangent / (1.0 + std::sqrt(1.0 + tangent * tangent));
  const double square = tangent * tangent;
  double sum = 0.0;
  for (int n = 23; n > 0; n -= 2) {
    sum = 1.0 / n - square * sum;
  }
  const double small = 4.0 * tangent * sum;
  const double off = std::abs(along) >= across ? small : 0.5 * std::numbers::pi - small;
  return along >= 0.0 ? off : std::numbers::pi - off;
}

}  // namespace fantail::sim
