// SPDX-License-Identifier: MIT
#include "sim/flight_computer.hpp"

#include "sim/simulated_board.hpp"

namespace fantail::sim {

std::unique_ptr<FlightComputer> simulated_board(const core::FlightPlan& plan, const BoardPorts& ports,
                                                const avionics::Identity& identity) {
  return std::make_unique<SimulatedBoard>(plan, ports, identity);
}

}  // namespace fantail::sim
