// SPDX-License-Identifier: MIT
#include "sim/rigid_body.hpp"

namespace fantail::sim {

RateOfChange rate_of_change(const RigidState& state, const Loads& loads, const Inertia& inertia,
                            double roll_rate_rad_s) {
  const double spin = inertia.roll_kg_m2 * roll_rate_rad_s;
  const double per_inertia = 1.0 / inertia.transverse_kg_m2;
  Vector3 acceleration_m_s2 = rotated(state.attitude, (1.0 / inertia.mass_kg) * loads.force_n);
  acceleration_m_s2.z -= gravity_m_s2;
  return {.velocity_m_s = state.velocity_m_s,
          .acceleration_m_s2 = acceleration_m_s2,
          .rate_rad_s = state.rate_rad_s,
          .acceleration_rad_s2 = {.x = 0.0,
                                  .y = per_inertia * (loads.moment_n_m.y - spin * state.rate_rad_s.z),
                                  .z = per_inertia * (loads.moment_n_m.z + spin * state.rate_rad_s.y)}};
}

RigidState moved(const RigidState& state, const RateOfChange& rate, double dt_s) {
  return {.position_m = state.position_m + dt_s * rate.velocity_m_s,
          .velocity_m_s = state.velocity_m_s + dt_s * rate.acceleration_m_s2,
          .attitude = renormalized(state.attitude * small_rotation(dt_s * rate.rate_rad_s)),
          .rate_rad_s = state.rate_rad_s + dt_s * rate.acceleration_rad_s2};
}

}  // namespace fantail::sim
