// SPDX-License-Identifier: MIT
#pragma once

#include "report/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::tool {

/// Flies a scenario to its end and keeps every tick. Throws Interrupted.
[[nodiscard]] report::Flight fly_scenario(const sim::Scenario& scenario);

}  // namespace fantail::tool
