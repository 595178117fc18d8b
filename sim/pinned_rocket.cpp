// SPDX-License-Identifier: MIT
#include "sim/pinned_rocket.hpp"

#include <algorithm>
#include <cmath>

#include "sim/air_loads.hpp"

namespace fantail::sim {

PinnedRocket::PinnedRocket(const PinParameters& pin, const Airframe& airframe, double mass_kg)
    : pin_{pin},
      airframe_{airframe},
      mass_kg_{mass_kg},
      pin_position_m_{airframe.at_liftoff.centre_of_gravity_m - pin.in_front_m},
      inertia_kg_m2_{airframe.at_liftoff.transverse_inertia_kg_m2 + mass_kg * pin.in_front_m * pin.in_front_m},
      kicks_to_come_{pin.kicks} {}

double PinnedRocket::acceleration_rad_s2(double angle_rad, double rate_rad_s, double density_kg_m3,
                                         double speed_m_s) const {
  const auto [sine, cosine] = sine_cosine(angle_rad);
  const Loads air = air_loads(airframe_, {.density_kg_m3 = density_kg_m3,
                                          .drag_area_m2 = 0.0,
                                          .centre_of_gravity_m = pin_position_m_,
                                          .air_speed_m_s = {.x = speed_m_s * cosine, .y = 0.0, .z = speed_m_s * sine},
                                          .rate_rad_s = {.y = rate_rad_s}});
  double moment_n_m = air.moment_n_m.y - mass_kg_ * gravity_m_s2 * pin_.in_front_m * sine -
                      pin_.stiffness_n_m_per_rad * angle_rad - pin_.friction_n_m_s * rate_rad_s;
  if (const double beyond_rad = std::abs(angle_rad) - pin_.tether_slack_rad; beyond_rad > 0.0) {
    moment_n_m -= std::copysign(pin_.tether_n_m_per_rad * beyond_rad, angle_rad);
  }
  return moment_n_m / inertia_kg_m2_;
}

void PinnedRocket::step(double time_s, double dt_s, double density_kg_m3, double speed_m_s) {
  constexpr double clock_tolerance_s = 1e-7;
  while (!kicks_to_come_.empty() && kicks_to_come_.front().time_s <= time_s + clock_tolerance_s) {
    rate_rad_s_ += kicks_to_come_.front().rate_rad_s;
    kicks_to_come_ = kicks_to_come_.subspan(1);
  }
  const double half_s = 0.5 * dt_s;
  const double first = acceleration_rad_s2(angle_rad_, rate_rad_s_, density_kg_m3, speed_m_s);
  const double middle_rate = rate_rad_s_ + half_s * first;
  const double middle = acceleration_rad_s2(angle_rad_ + half_s * rate_rad_s_, middle_rate, density_kg_m3, speed_m_s);
  angle_rad_ += dt_s * middle_rate;
  rate_rad_s_ += dt_s * middle;
  acceleration_rad_s2_ = middle;
  if (std::abs(angle_rad_) > pin_.wall_rad) {
    angle_rad_ = std::copysign(pin_.wall_rad, angle_rad_);
    rate_rad_s_ = 0.0;
  }
}

BodyMotion PinnedRocket::motion() const {
  const auto [sine, cosine] = sine_cosine(angle_rad_);
  return {.specific_force_m_s2 = {.x = gravity_m_s2 * cosine, .y = 0.0, .z = gravity_m_s2 * sine},
          .rate_rad_s = {.y = rate_rad_s_},
          .angular_acceleration_rad_s2 = {.y = acceleration_rad_s2_}};
}

}  // namespace fantail::sim
