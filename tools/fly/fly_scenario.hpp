// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/tick_record.hpp"
#include "flight/flight.hpp"
#include "sim/flight_computer.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// Called about once a simulated second, with the seconds since power-up. What it throws ends the flight.
using Look = std::function<void(double simulated_s)>;

/// Called with every tick, in order, for who wants more than the flight keeps.
using Observe = std::function<void(const core::TickRecord& record)>;

/// Of what the avionics records itself, flight::Flight::log: nobody wants it, or all that its flash can hold.
enum class Log : std::uint8_t { dropped, kept };

/// Flies a scenario to its end and keeps every tick, or as many as it says. Safe to call from several threads, each
/// with flight computers of its own.
[[nodiscard]] flight::Flight fly_scenario(const sim::Scenario& scenario, const Look& look = {},
                                          const Observe& observe = {}, Log log = Log::dropped,
                                          const sim::MakeFlightComputer& make = sim::simulated_board);

/// Seconds from power-up to the end, where they are known beforehand: in the tunnel.
[[nodiscard]] std::optional<double> expected_length_s(const sim::Scenario& scenario);

}  // namespace fantail::fly
