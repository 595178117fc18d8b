// SPDX-License-Identifier: MIT
#include "sim/environment.hpp"

#include <cmath>

namespace fantail::sim {

Environment::Environment(const Scenario& scenario, Random turbulence)
    : turbulence_{turbulence}, time_s_{-scenario.pad_time_s} {
  if (scenario.surroundings == Surroundings::tunnel) {
    fan_to_come_ = scenario.fan_programme;
    fan_rpm_ = scenario.tunnel.fan_rpm;
    tunnel_.emplace(scenario.tunnel, turbulence_.gaussian());
  } else {
    ascent_.emplace(AscentParameters{.mass_kg = scenario.vehicle.mass_kg,
                                     .drag_area_m2 = scenario.vehicle.drag_area_m2,
                                     .guide_tilt_rad = scenario.guide_tilt_rad,
                                     .atmosphere = scenario.atmosphere,
                                     .motor = scenario.vehicle.motor});
  }
}

void Environment::advance_to(double time_s) {
  if (ascent_) {
    ascent_->advance_to(time_s);
  } else if (time_s > time_s_) {
    follow_fan_programme();
    tunnel_->step(time_s - time_s_, turbulence_.gaussian());
  }
  time_s_ = time_s;
}

void Environment::follow_fan_programme() {
  constexpr double clock_tolerance_s = 1e-7;  // ticks are whole microseconds, seconds are not exact
  while (!fan_to_come_.empty() && fan_to_come_.front().time_s <= time_s_ + clock_tolerance_s) {
    fan_rpm_ = fan_to_come_.front().fan_rpm;
    tunnel_->set_fan_rpm(fan_rpm_);
    fan_to_come_ = fan_to_come_.subspan(1);
  }
}

Vector3 Environment::specific_force_m_s2(double roll_angle_rad) const {
  if (!ascent_) {
    return {.x = gravity_m_s2};
  }
  const double lateral_m_s2 = ascent_->lateral_specific_force_m_s2();
  if (lateral_m_s2 == 0.0) {
    return {.x = ascent_->axial_specific_force_m_s2()};
  }
  // The guide leans towards one side of the rocket; rolling turns that side away from where the sensor's axes point.
  return {.x = ascent_->axial_specific_force_m_s2(),
          .y = lateral_m_s2 * std::cos(roll_angle_rad),
          .z = -lateral_m_s2 * std::sin(roll_angle_rad)};
}

}  // namespace fantail::sim
