// SPDX-License-Identifier: MIT
#include "sim/air_loads.hpp"

#include <cmath>

namespace fantail::sim {

Loads air_loads(const Airframe& airframe, const InAir& in_air) {
  const Vector3& v = in_air.air_speed_m_s;
  const Vector3& rate = in_air.rate_rad_s;
  const double speed_m_s = length(v);
  const double half_flow = 0.5 * in_air.density_kg_m3 * speed_m_s;

  // Sums over the parts of slope times area, times the arm in front of the centre of gravity, times its square.
  const double sum = airframe.normal_force_slope_per_rad * airframe.cross_section_m2() * in_air.normal_force_factor;
  const double arm_m = in_air.centre_of_gravity_m - airframe.centre_of_pressure_m;
  const double arm_sum = sum * arm_m;
  const double square_sum = sum * (arm_m * arm_m + airframe.parts_spread_m * airframe.parts_spread_m);

  const double cross_flow_m_s = std::sqrt(v.y * v.y + v.z * v.z);
  const double cross = 0.5 * in_air.density_kg_m3 * airframe.body_lift_area_m2 * cross_flow_m_s;
  const double cross_arm_m = in_air.centre_of_gravity_m - airframe.body_lift_position_m;

  return {.force_n = {.x = -half_flow * in_air.drag_area_m2 * v.x,
                      .y = -half_flow * (sum * v.y + arm_sum * rate.z) - cross * v.y,
                      .z = -half_flow * (sum * v.z - arm_sum * rate.y) - cross * v.z},
          .moment_n_m = {.x = 0.0,
                         .y = half_flow * (arm_sum * v.z - square_sum * rate.y) + cross * cross_arm_m * v.z,
                         .z = -half_flow * (arm_sum * v.y + square_sum * rate.z) - cross * cross_arm_m * v.y}};
}

double angle_of_attack_rad(const Vector3& v) { return angle_off(v.x, std::sqrt(v.y * v.y + v.z * v.z)); }

}  // namespace fantail::sim
