// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// What is known of a flight before it is flown: what flies by which plan, and in notes what was assumed and is broken.
/// Not Flight::side_moment_m3.
[[nodiscard]] flight::Flight describe(const sim::Scenario& scenario);

/// Flight::side_moment_m3 of a vehicle. It builds the airframe up from its shape, which takes its time.
[[nodiscard]] std::optional<double> side_moment_m3(const sim::Vehicle& vehicle);

}  // namespace fantail::fly
