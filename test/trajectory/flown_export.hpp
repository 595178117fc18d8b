// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "sim/world.hpp"

namespace fantail::test {

/// Our own flight at one instant, as another program would export it.
struct Instant {
  double time_s;  ///< after ignition
  double height_m;
  double speed_m_s;  ///< over ground
  double up_m_s;
  double across_m_s;
  double tilt_rad;
  double density_kg_m3;
  double air_speed_m_s;
  double angle_of_attack_rad;
};

inline std::vector<Instant> instants(const sim::Scenario& scenario, int ticks_between) {
  std::vector<Instant> all;
  sim::World world{scenario};
  for (int tick = 0; !world.over(); ++tick) {
    (void)world.tick();
    const double time_s = 1e-6 * static_cast<double>(world.now().count()) - scenario.pad_time_s;
    if (tick % ticks_between == 0 && time_s > -0.5) {
      const sim::Truth truth = world.truth();
      const double density_kg_m3 = scenario.atmosphere.density_kg_m3(truth.height_m);
      if (const auto path = world.path()) {
        const sim::Vector3& v = path->velocity_m_s;
        all.push_back({time_s, path->position_m.z, length(v), v.z, std::hypot(v.x, v.y), path->tilt_rad, density_kg_m3,
                       truth.speed_m_s / std::cos(path->angle_of_attack_rad), path->angle_of_attack_rad});
      } else {
        const double up_m_s = truth.speed_m_s * std::cos(scenario.guide.tilt_rad);
        all.push_back({time_s, truth.height_m, std::abs(truth.speed_m_s), up_m_s,
                       std::abs(truth.speed_m_s) * std::sin(scenario.guide.tilt_rad), scenario.guide.tilt_rad,
                       density_kg_m3, truth.speed_m_s, 0.0});
      }
    }
    world.advance();
  }
  return all;
}

/// As RocketPy 1.9 writes it: SI, six decimals, the axis above the horizon.
inline std::string as_rocketpy(const std::vector<Instant>& instants) {
  std::string text =
      "# Time (s), Altitude AGL (m), Speed - Velocity Magnitude (m/s), Vz (m/s), Density (kg/m\u00b3), Attitude Angle "
      "(\u00b0)\n";
  for (const Instant& at : instants) {
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", at.time_s, at.height_m, at.speed_m_s, at.up_m_s,
                        at.density_kg_m3, 90.0 - at.tilt_rad * 180.0 / M_PI);
  }
  return text;
}

/// In wind it tells what meets the rocket, too.
inline std::string as_rocketpy_in_wind(const std::vector<Instant>& instants) {
  std::string text =
      "# Time (s), Altitude AGL (m), Vz (m/s), Horizontal Speed (m/s), Density (kg/m\u00b3), Attitude Angle (\u00b0), "
      "Freestream Speed (m/s), Angle of Attack (\u00b0)\n";
  for (const Instant& at : instants) {
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", at.time_s, at.height_m, at.up_m_s,
                        at.across_m_s, at.density_kg_m3, 90.0 - at.tilt_rad * 180.0 / M_PI, at.air_speed_m_s,
                        at.angle_of_attack_rad * 180.0 / M_PI);
  }
  return text;
}

/// As OpenRocket writes it for somebody who likes feet, with comments and an event in between.
inline std::string as_openrocket(const std::vector<Instant>& instants) {
  std::string text =
      "# Simulation 1 (Up to date)\r\n# 4242 data points written for 6 variables.\r\n#\r\n"
      "# Time (s),Altitude (ft),Vertical velocity (mph),Lateral velocity (ft/s),Vertical orientation (zenith) "
      "(rad),Air "
      "density (g/cm\u00b3)\r\n# Event LAUNCH occurred at t=0 seconds\r\n";
  for (const Instant& at : instants) {
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.8f},{:.8f}\r\n", at.time_s, at.height_m / 0.3048,
                        at.up_m_s / 0.44704, at.across_m_s / 0.3048, 0.5 * M_PI - at.tilt_rad, 1e-3 * at.density_kg_m3);
  }
  return text + "# Event SIMULATION_END occurred at t=20 seconds\r\n";
}

}  // namespace fantail::test
