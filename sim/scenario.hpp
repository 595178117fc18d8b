// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/atmosphere.hpp"
#include "sim/disturbance.hpp"
#include "sim/fault.hpp"
#include "sim/vehicle.hpp"
#include "sim/wind_tunnel.hpp"

namespace fantail::sim {

enum class Surroundings : std::uint8_t { flight, tunnel };

/// Roll angle and rate put on the rocket once, for a transient whose cause no model explains.
struct ImposedRoll {
  double time_s;  ///< after lift-off
  double angle_rad;
  double rate_rad_s;
};

/// The tunnel's fan from a time on.
struct FanSetPoint {
  double time_s;  ///< after the start command
  double fan_rpm;
};

/// One run: who flies, by which plan, in which world.
struct Scenario {
  std::string name;
  std::string plan_name;
  std::string vehicle_name;
  std::uint64_t seed = 1;
  std::vector<std::string> assumed;   ///< beside what the vehicle's file assumes, a sentence each
  std::vector<std::string> warnings;  ///< what is doubtful in its files, beside those of the vehicle, a sentence each
  core::FlightPlan plan{};
  Vehicle vehicle;
  Surroundings surroundings = Surroundings::flight;
  Atmosphere atmosphere{};
  double guide_tilt_rad = 0.0;
  double wind_m_s = 0.0;          ///< stated, not flown: to say where the simulation does not hold
  double pad_time_s = 10.0;       ///< from power-up to ignition, or to the start command
  double arm_time_s = 1.0;        ///< after power-up
  double time_after_end_s = 1.0;  ///< goes on this long after apogee, or after control has ended in the tunnel
  double log_period_s = 0.001;    ///< between the rows that are kept of a run; whole milliseconds
  WindTunnelParameters tunnel{};
  std::vector<FanSetPoint> fan_programme;  ///< after tunnel.fan_rpm, which holds until the first of them
  WindSensor wind_sensor{};
  std::vector<DisturbanceNode> disturbance;  ///< times after lift-off, or after control start in the tunnel
  std::optional<ImposedRoll> imposed_roll;
  std::vector<Fault> faults;
  std::optional<std::string> tunnel_result;  ///< what a prediction of this flight starts from; not flown
};

}  // namespace fantail::sim
