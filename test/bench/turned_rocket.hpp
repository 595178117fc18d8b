// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "bench/axes.hpp"
#include "degree.hpp"
#include "sim/units.hpp"

namespace fantail::bench {

using sim::Vector3;
using sim::operator*;

/// What a sensor makes of a vector of the body, row by row.
using Matrix = std::array<std::array<double, 3>, 3>;
inline constexpr Matrix identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Vector3 through(const Matrix& m, const Vector3& v) {
  const auto row = [&](std::size_t i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}

inline double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

inline sim::Quaternion rotation(const Vector3& angle_rad) {
  const double angle = sim::length(angle_rad);
  const double share = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {.w = std::cos(0.5 * angle), .x = share * angle_rad.x, .y = share * angle_rad.y, .z = share * angle_rad.z};
}

struct Rocket {
  Matrix gyro = identity;
  Matrix accelerometer = identity;
  Matrix second = identity;
  Vector3 roll_rad{.x = 360.0 * degree};
  Vector3 tilt_rad{.y = 90.0 * degree};
  Vector3 tilt_across_rad{.z = 90.0 * degree};
};

inline TurnsSeen turned(const Rocket& rocket) {
  const Vector3 up{.x = sim::gravity_m_s2};
  const auto seen_of = [&](const Vector3& turn_rad) {
    const Vector3 after = sim::rotated_back(rotation(turn_rad), up);
    const Vector3 seen_rad = through(rocket.gyro, turn_rad);
    return TurnSeen{.before_m_s2 = {through(rocket.accelerometer, up), through(rocket.second, up)},
                    .after_m_s2 = {through(rocket.accelerometer, after), through(rocket.second, after)},
                    .angle_rad = seen_rad,
                    .turned = rotation(seen_rad)};
  };
  return {seen_of(rocket.roll_rad), seen_of(rocket.tilt_rad), TurnSeen{}, seen_of(rocket.tilt_across_rad)};
}

}  // namespace fantail::bench
