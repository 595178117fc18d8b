// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// The rocket of a flight without control: the same scenario, seed and faults, flown by a plan whose gains are zero and
/// which neither excites nor rejects an offset, so that all it ever commands is trim. A point every 10 ms. Empty where
/// that says nothing: without control in the flight or in its plan, and on the gimbal and on pins, where something else
/// holds the rocket.
[[nodiscard]] std::vector<flight::FreeRollPoint> roll_without_control(const sim::Scenario& scenario,
                                                                      const flight::Flight& flight,
                                                                      const Look& look = {});

}  // namespace fantail::fly
