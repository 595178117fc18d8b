// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "json/value.hpp"

namespace fantail::tool {

/// Every field of a plan by section and key, in the units of plan files.
[[nodiscard]] json::Value plan_json(const core::FlightPlan& plan);

}  // namespace fantail::tool
