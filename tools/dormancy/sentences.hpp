// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dormancy/entry.hpp"
#include "dormancy/outlook.hpp"
#include "sim/scenario.hpp"

namespace fantail::dormancy {

// Clauses, without a capital letter and a full stop.

/// When the gate opens, how the rocket moves then, and what capture makes of it. Empty for a plan that waits for the
/// guide alone, and where the canards stay at trim.
[[nodiscard]] std::string opening_clause(const sim::Scenario& scenario, const Outlook& outlook,
                                         const std::optional<CaptureForecast>& forecast);

/// That the canards stay at trim because the plan's gate stays closed; empty where they do not, or something else ended
/// the flight for them.
[[nodiscard]] std::string never_opened(const sim::Scenario& scenario, const Outlook& outlook);

/// Of a plan for a launch alone: where it breaks what ranges ask for, or hinders its own capture.
[[nodiscard]] std::vector<std::string> doubts(const core::FlightPlan& plan);

/// Of this plan in this rocket.
[[nodiscard]] std::vector<std::string> doubts(const sim::Scenario& scenario, const Outlook& outlook,
                                              const std::optional<CaptureForecast>& forecast);

}  // namespace fantail::dormancy
