// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace fantail::sim {

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// Standard gravity: what the rocket falls with, and what its accelerometers read on the pad.
inline constexpr double gravity_m_s2 = 9.80665;

/// Three components in the rocket's body frame: x along the axis towards the nose; positive roll turns y towards z.
struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

}  // namespace fantail::sim
