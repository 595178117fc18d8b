// SPDX-License-Identifier: MIT
#pragma once

#include "sim/airframe.hpp"
#include "sim/rigid_body.hpp"

namespace fantail::sim {

/// A rocket in the air at an instant. Vectors are in the frame of RigidState.
struct InAir {
  double density_kg_m3 = 0.0;
  double drag_area_m2 = 0.0;
  double centre_of_gravity_m = 0.0;  ///< from the tip of the nose
  Vector3 air_speed_m_s;             ///< of the rocket through the air
  Vector3 rate_rad_s;
  double normal_force_factor = 1.0;  ///< on the slope of the parts; the body's own lift is left as it is
};

/// Drag along the axis, the normal force of the parts, and the lift of the body in a strong cross flow, with their
/// moments about the centre of gravity. Each part sees the flow across it at its own place, so that pitching is damped.
///
/// The normal force is in proportion to the sine of the angle of attack: the stall of fins is not in it.
[[nodiscard]] Loads air_loads(const Airframe& airframe, const InAir& in_air);

/// Zero where nothing moves.
[[nodiscard]] double angle_of_attack_rad(const Vector3& air_speed_m_s);

}  // namespace fantail::sim
