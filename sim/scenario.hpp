// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/atmosphere.hpp"
#include "sim/disturbance.hpp"
#include "sim/fault.hpp"
#include "sim/gimbal.hpp"
#include "sim/launch_guide.hpp"
#include "sim/pinned_rocket.hpp"
#include "sim/prescribed_flight.hpp"
#include "sim/vehicle.hpp"
#include "sim/wind.hpp"
#include "sim/wind_tunnel.hpp"

namespace fantail::sim {

enum class Surroundings : std::uint8_t { flight, tunnel, gimbal };

enum class FlightMotion : std::uint8_t {
  straight,  ///< along the line of the guide, whatever gravity and wind would do
  six_dof,   ///< six degrees of freedom; needs the vehicle's airframe
};

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
  std::size_t changed_values = 0;     ///< on the command line, after its files were read; the flight's record says it
  std::vector<std::string> assumed;   ///< beside what the vehicle's file assumes, a sentence each
  std::vector<std::string> warnings;  ///< what is doubtful in its files, beside those of the vehicle, a sentence each
  core::FlightPlan plan{};
  Vehicle vehicle;
  Surroundings surroundings = Surroundings::flight;
  Atmosphere atmosphere{};
  FlightMotion motion = FlightMotion::straight;
  /// In flight: what somebody else has flown, instead of a motion of our own. With six_dof the inertia follows the
  /// propellant all the same.
  std::optional<PrescribedPath> path{};
  LaunchGuide guide{};            ///< as it truly stands
  WindParameters wind{};          ///< flown in six degrees of freedom; along a straight line it is only stated
  WindSpread wind_spread{};       ///< what a prediction draws the wind with; not flown
  double pad_time_s = 10.0;       ///< from power-up to ignition, or to the start command
  double arm_time_s = 1.0;        ///< after power-up
  double time_after_end_s = 1.0;  ///< goes on this long after apogee and burn-out, or after control in the tunnel
  double log_period_s = 0.001;    ///< between the rows that are kept of a run; whole milliseconds
  WindTunnelParameters tunnel{};
  std::vector<FanSetPoint> fan_programme;  ///< after tunnel.fan_rpm, which holds until the first of them
  WindSensor wind_sensor{};
  std::optional<PinParameters> pin;  ///< in the tunnel, instead of a string at the nose: free in pitch, held in roll
  std::vector<HandTurn> hand_turns;  ///< on the gimbal
  std::optional<double> gimbal_friction_n_m{};  ///< given: the hands let go; with an airframe
  std::vector<DisturbanceNode> disturbance;     ///< times after lift-off, or after control start in the tunnel
  std::optional<ImposedRoll> imposed_roll;
  std::vector<Fault> faults;
  std::uint64_t fault_variant = 0;  ///< other random numbers of the faults (garbage, which bit) with the same seed
  /// Asked of the roll, and not flown: resting farther from its reference than this it is not where it was wanted.
  double rest_limit_rad = 10.0 * radians_per_degree;
  double tilt_end_before_apogee_s = 0.5;     ///< likewise: sooner before apogee its tilt limit must not end control
  std::optional<std::string> tunnel_result;  ///< what a prediction of this flight starts from; not flown
};

}  // namespace fantail::sim
