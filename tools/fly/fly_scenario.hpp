// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

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

/// Called with every row instead of Flight::rows, in order, and with the flight as far as it is known by then, but for
/// its outages. Both count time from power-up: Flight::clock, in the end, is from there to the clock of a flight's
/// rows.
using TakeRow = std::function<void(const flight::Row& row, const flight::Flight& so_far)>;

/// The same flight without its rows and without Flight::side_moment_m3, which only rows have a use for.
[[nodiscard]] flight::Flight fly_without_rows(const sim::Scenario& scenario, const TakeRow& take);

/// Of every row under control, in order. Near apogee nothing flows: the lowest speed that counts is
/// flight::slowest_held_m_s, or that at which control began where it is lower.
[[nodiscard]] std::vector<double> speeds_under_control_m_s(const sim::Scenario& scenario);

/// Seconds from power-up to the end, where they are known beforehand: in the tunnel.
[[nodiscard]] std::optional<double> expected_length_s(const sim::Scenario& scenario);

/// The rocket of a flight without control: the same scenario, seed and faults, flown by a plan whose gains are zero and
/// which neither excites nor rejects an offset, so that all it ever commands is trim. A point every 10 ms. Empty where
/// that says nothing: without control in the flight or in its plan, and on the gimbal and on pins, where something else
/// holds the rocket.
[[nodiscard]] std::vector<flight::FreeRollPoint> roll_without_control(const sim::Scenario& scenario,
                                                                      const flight::Flight& flight,
                                                                      const Look& look = {});

}  // namespace fantail::fly
