// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// What is known of a flight before it is flown: what flies by which plan, and in notes what was assumed and is broken.
/// Not Flight::side_moment_m3.
[[nodiscard]] flight::Flight describe(const sim::Scenario& scenario);

/// Of a plan that uses a barometer: it counts on another air temperature than the scenario has, a clause. Empty: not.
[[nodiscard]] std::string wrong_air_temperature(const sim::Scenario& scenario);

/// What is broken, since when and by how much: "Fault: canard_stuck, canard 1, from 2.5 s after ignition."
[[nodiscard]] std::string fault_text(const sim::Fault& fault, const sim::Scenario& scenario);

/// The faults that would have begun after the end of the run, which is `end_s` after ignition or the start command: a
/// sentence each. Empty: all began.
[[nodiscard]] std::string never_happened(const sim::Scenario& scenario, double end_s);

/// Of one canard: side force over 1/2 rho v^2 and its angle, and where it acts, from the tip of the nose.
struct CanardSide {
  double area_m2;
  double position_m;
};

/// From the roll torque that the vehicle states and its shape, which it builds up: that takes its time. Empty without a
/// shape.
[[nodiscard]] std::optional<CanardSide> canard_side(const sim::Vehicle& vehicle);

/// Flight::side_moment_m3 of a vehicle. It builds the airframe up from its shape, which takes its time.
[[nodiscard]] std::optional<double> side_moment_m3(const sim::Vehicle& vehicle);

}  // namespace fantail::fly
