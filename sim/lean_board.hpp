// SPDX-License-Identifier: MIT
#pragma once

#include "sim/flight_computer.hpp"
#include "sim/scenario.hpp"

namespace fantail::sim {

/// For flights of which nobody wants the record: the avionics of simulated_board() without recorder, reports in flight,
/// watch over its memory and state for a reset, which are a quarter of a simulated flight. Every record that tick()
/// returns is the same to the last bit, and so is all that the pad crew hears, as long as nothing of the scenario
/// breaks.
///
/// Where the scenario has faults, which may be for any of these, it is the whole avionics.
[[nodiscard]] MakeFlightComputer unrecorded_board(const Scenario& scenario);

}  // namespace fantail::sim
