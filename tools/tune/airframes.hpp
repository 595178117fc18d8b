// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::tune {

/// The scenario with the vehicle's damping and torque times these.
[[nodiscard]] sim::Scenario with_airframe(sim::Scenario scenario, double damping_factor, double torque_factor);

/// The vehicle as it is, then the four corners of the spread. A spread of 1 is the vehicle alone.
[[nodiscard]] std::vector<sim::Scenario> corners(const sim::Scenario& scenario, double spread);

/// With the middles of the spread's four sides, too.
[[nodiscard]] std::vector<sim::Scenario> corners_and_middles(const sim::Scenario& scenario, double spread);

/// One rocket of the spread: both factors log-uniform, by the seed, which is also that of the flight.
[[nodiscard]] sim::Scenario drawn(const sim::Scenario& scenario, double spread, std::uint64_t seed);

}  // namespace fantail::tune
