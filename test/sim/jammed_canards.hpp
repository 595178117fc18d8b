// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "flown_world.hpp"

namespace fantail::sim {

/// alpha and beta of the vehicle below, and its air.
inline constexpr double alpha_m2 = 19.4;
inline constexpr double beta_m = 9.6;
inline constexpr double tunnel_m_s = 22.0;

/// The rocket hangs in a steady stream of 22 m/s, free to roll, and from half a second after control start its canards
/// are jammed, each at its own angle. The roll time constant is 0.3 s.
inline Scenario jammed(const std::array<double, 4>& angles_deg, const std::vector<std::string>& changes = {}) {
  std::vector<std::string> all{"disturbance.angles_deg=[0]", "tunnel.swirl_deg=0", "tunnel.turbulence=0",
                               "reference.kind=hold", "run.control_time_s=10"};
  all.insert(all.end(), changes.begin(), changes.end());
  Scenario s = scenario("tunnel_steps", all);
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    s.faults.push_back({.device = Device::servo,
                        .canard = i,
                        .how = GearFault{ServoFault::stuck, angles_deg[i] * degree},
                        .from_s = 0.5});
  }
  return s;
}

/// The roll rate in the end, in degrees a second.
inline double steady_rate_deg_s(const Scenario& scenario) {
  return fly(scenario).at(9.9).truth.roll_rate_rad_s / degree;
}

}  // namespace fantail::sim
