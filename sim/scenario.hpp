// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/atmosphere.hpp"
#include "sim/disturbance.hpp"
#include "sim/document.hpp"
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

enum class FaultKind : std::uint8_t {
  canard_stuck,
  canard_hardover,
  canard_dead,
  canard_slipping,
  canard_reversed,
  encoder_unplugged,
  imu_dropout,
  accelerometer_dropout,
};

/// As in scenario files.
[[nodiscard]] std::string_view name(FaultKind kind);

/// Lasts for a while and concerns no canard.
[[nodiscard]] constexpr bool is_dropout(FaultKind kind) {
  return kind == FaultKind::imu_dropout || kind == FaultKind::accelerometer_dropout;
}

struct Fault {
  FaultKind kind;
  std::size_t canard;  ///< 0 to 3; for canard and encoder faults
  double from_s;       ///< after ignition (in the tunnel: after the start command); negative on the pad
  double until_s;      ///< dropouts only
};

/// One run: who flies, by which plan, in which world.
struct Scenario {
  std::string name;
  std::string plan_name;
  std::string vehicle_name;
  std::uint64_t seed = 1;
  std::vector<std::string> assumed;  ///< beside what the vehicle's file assumes, a sentence each
  core::FlightPlan plan{};
  Vehicle vehicle;
  Surroundings surroundings = Surroundings::flight;
  Atmosphere atmosphere{};
  double guide_tilt_rad = 0.0;
  double pad_time_s = 5.0;        ///< from power-up to ignition, or to the start command
  double arm_time_s = 1.0;        ///< after power-up
  double time_after_end_s = 1.0;  ///< goes on this long after apogee, or after control has ended in the tunnel
  WindTunnelParameters tunnel{};
  std::vector<DisturbanceNode> disturbance;  ///< times after lift-off, or after control start in the tunnel
  std::optional<ImposedRoll> imposed_roll;
  std::vector<Fault> faults;
};

/// A shipped name or a path, with changes from the command line, which may reach into the scenario, its plan or its
/// vehicle. Throws InputError.
[[nodiscard]] Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes);

}  // namespace fantail::sim
