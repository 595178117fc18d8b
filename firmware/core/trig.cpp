// SPDX-License-Identifier: MIT
#include "core/trig.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace fantail::core {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// Minimax polynomials on [-pi/4, pi/4].
float sin_near_zero(float x) {
  const float s = x * x;
  return x + x * s * (-1.6666654611e-1F + s * (8.3321608736e-3F + s * -1.9515295891e-4F));
}

float cos_near_zero(float x) {
  const float s = x * x;
  return 1.0F - 0.5F * s + s * s * (4.166664568298827e-2F + s * (-1.388731625493765e-3F + s * 2.443315711809948e-5F));
}

// Round to the nearest integer; |x| is already bounded, so the conversion cannot overflow.
std::int32_t nearest(float x) { return static_cast<std::int32_t>(x < 0.0F ? x - 0.5F : x + 0.5F); }

// The value of sine `quarter_turns` further on than x.
float sin_of_quadrant(std::int32_t quarter_turns, float x) {
  switch (static_cast<std::uint32_t>(quarter_turns) & 3U) {
    case 0: return sin_near_zero(x);
    case 1: return cos_near_zero(x);
    case 2: return -sin_near_zero(x);
    default: return -cos_near_zero(x);
  }
}

float sin_shifted(Angle angle, std::int32_t extra_quarter_turns) {
  const float x = angle.radians();
  if (!(x >= -10000.0F && x <= 10000.0F)) {
    return not_a_number;
  }
  const std::int32_t quarter_turns = nearest(x * (2.0F / pi));
  const auto n = static_cast<float>(quarter_turns);
  // pi/2 in three parts whose leading ones have trailing zeros, so that n times each of them is exact (Cody and Waite).
  const float reduced = ((x - n * 1.5703125F) - n * 4.837512969970703125e-4F) - n * 7.549789948768648e-8F;
  return sin_of_quadrant(quarter_turns + extra_quarter_turns, reduced);
}

}  // namespace

float sin(Angle angle) { return sin_shifted(angle, 0); }

float cos(Angle angle) { return sin_shifted(angle, 1); }

float sin_turns(float turns) {
  if (!(turns >= -1e6F && turns <= 1e6F)) {
    return not_a_number;
  }
  const std::int32_t quarter_turns = nearest(turns * 4.0F);
  const float reduced = turns - static_cast<float>(quarter_turns) * 0.25F;  // exact: both share an exponent or less
  return sin_of_quadrant(quarter_turns, reduced * (2.0F * pi));
}

Angle atan2(float y, float x) {
  const float abs_x = std::abs(x);
  const float abs_y = std::abs(y);
  if (abs_x == 0.0F && abs_y == 0.0F) {
    return Angle{};
  }
  // Fold to a slope in [0, 1], then to [-tan(pi/8), tan(pi/8)], where the polynomial lives.
  const bool steep = abs_y > abs_x;
  const float slope = steep ? abs_x / abs_y : abs_y / abs_x;
  const bool upper = slope > 0.4142135623730950F;
  const float z = upper ? (slope - 1.0F) / (slope + 1.0F) : slope;
  const float s = z * z;
  float result =
      z + z * s * (-3.33329491539e-1F + s * (1.99777106478e-1F + s * (-1.38776856032e-1F + s * 8.05374449538e-2F)));
  if (upper) {
    result += pi / 4.0F;
  }
  if (steep) {
    result = pi / 2.0F - result;
  }
  if (x < 0.0F) {
    result = pi - result;
  }
  return Angle::from_radians(y < 0.0F ? -result : result);
}

}  // namespace fantail::core
