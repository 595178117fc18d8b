// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::tool {

/// Where the plan of a scenario states the launch guide or the air otherwise than the scenario does.
[[nodiscard]] std::vector<std::string> plan_against_scenario(const sim::Scenario& scenario);

}  // namespace fantail::tool
