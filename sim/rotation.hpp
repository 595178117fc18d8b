// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "sim/units.hpp"

// Vectors and rotations in double precision, from exact operations and the square root alone: the same bits on every
// machine.
namespace fantail::sim {

[[nodiscard]] constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr Vector3 operator*(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
[[nodiscard]] constexpr double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(const Vector3& v) { return std::sqrt(dot(v, v)); }

/// A rotation from one frame into another, of unit length.
struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// First `b`, then `a`.
[[nodiscard]] constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {.w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
          .x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          .y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          .z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

[[nodiscard]] constexpr Vector3 rotated(const Quaternion& q, const Vector3& v) {
  const Vector3 axis{q.x, q.y, q.z};
  const Vector3 twice = 2.0 * cross(axis, v);
  return v + q.w * twice + cross(axis, twice);
}

[[nodiscard]] constexpr Vector3 rotated_back(const Quaternion& q, const Vector3& v) {
  return rotated({.w = q.w, .x = -q.x, .y = -q.y, .z = -q.z}, v);
}

/// One Newton step back to unit length, for a quaternion within 1e-4 of it.
[[nodiscard]] constexpr Quaternion renormalized(const Quaternion& q) {
  const double factor = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {.w = factor * q.w, .x = factor * q.x, .y = factor * q.y, .z = factor * q.z};
}

/// The rotation by a vector angle (radians about each axis at once), from the series of half-angle sine and cosine: to
/// 1e-14 up to 0.1 rad, which is a turn of 100 rad/s in a millisecond.
[[nodiscard]] constexpr Quaternion small_rotation(const Vector3& angle_rad) {
  const double square = 0.25 * dot(angle_rad, angle_rad);
  const double half_sine = 0.5 * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square / 5040.0)));
  const double cosine = 1.0 - square * (1.0 / 2.0 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square / 40320.0)));
  return {.w = cosine, .x = half_sine * angle_rad.x, .y = half_sine * angle_rad.y, .z = half_sine * angle_rad.z};
}

struct SineCosine {
  double sine;
  double cosine;
};

/// Of any angle up to 1e6 rad, to 1e-14 near zero and 1e-10 at the far end. The C library's are not the same on every
/// machine.
[[nodiscard]] SineCosine sine_cosine(double angle_rad);

/// Between the direction (along, across) and that of `along`: 0 to pi; `across` is not negative. Zero for no direction.
[[nodiscard]] double angle_off(double along, double across);

}  // namespace fantail::sim
