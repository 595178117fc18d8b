// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/flight_plan.hpp"

namespace fantail::tool {

/// Where a plan for a launch is weaker than those that the safety case is about (docs/safety.md, "Which plans"). The
/// firmware takes it all the same.
[[nodiscard]] std::vector<std::string> weaker_than_shipped(const core::FlightPlan& plan);

}  // namespace fantail::tool
