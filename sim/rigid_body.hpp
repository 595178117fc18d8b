// SPDX-License-Identifier: MIT
#pragma once

#include "sim/rotation.hpp"

namespace fantail::sim {

/// A rocket that is the same all around its long axis, moving and turning freely.
///
/// Its frame has x along the axis towards the nose, and does not roll with the rocket: it turns about y and z only. So
/// pitch and yaw stay slow however fast the rocket spins, the roll angle against it is the integral of the roll rate,
/// and the roll plant keeps the roll to itself. Earth: x north, y west, z up.
struct RigidState {
  Vector3 position_m;    ///< of the centre of gravity, earth
  Vector3 velocity_m_s;  ///< earth
  Quaternion attitude;   ///< from the frame to the earth
  Vector3 rate_rad_s;    ///< of the frame, in the frame; x is zero
};

/// Forces and moments on the rocket at an instant, in its frame.
struct Loads {
  Vector3 force_n;     ///< all but gravity
  Vector3 moment_n_m;  ///< about the centre of gravity; y and z count
};

struct Inertia {
  double mass_kg = 0.0;
  double transverse_kg_m2 = 0.0;
  double roll_kg_m2 = 0.0;
};

/// How fast a state changes.
struct RateOfChange {
  Vector3 velocity_m_s;         ///< earth
  Vector3 acceleration_m_s2;    ///< earth
  Vector3 rate_rad_s;           ///< frame
  Vector3 acceleration_rad_s2;  ///< frame; x is zero
};

/// Newton and Euler. A spinning rocket answers a moment across its axis as a gyroscope does:
///   I q' = M_y - I_x p r      I r' = M_z + I_x p q
[[nodiscard]] RateOfChange rate_of_change(const RigidState& state, const Loads& loads, const Inertia& inertia,
                                          double roll_rate_rad_s);

/// The state `dt_s` later at this pace, turned by the exact rotation.
[[nodiscard]] RigidState moved(const RigidState& state, const RateOfChange& rate, double dt_s);

/// The state `dt_s` later by the midpoint rule: the error of a flight falls with the square of the step. `at(state,
/// after_s)` is the rate of change of that state, so long after the begin of the step; `first` is that of the begin.
template <typename RateOfChangeAt>
[[nodiscard]] RigidState stepped(const RigidState& state, const RateOfChange& first, double dt_s, RateOfChangeAt at) {
  return moved(state, at(moved(state, first, 0.5 * dt_s), 0.5 * dt_s), dt_s);
}

}  // namespace fantail::sim
