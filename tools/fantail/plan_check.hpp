// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "json/value.hpp"

namespace fantail::tool {

struct PlanCheck {
  std::optional<std::string> plan{};      ///< a plan, or a scenario with a plan of its own
  std::optional<std::string> scenario{};  ///< whose rocket the plan is to fly
  std::optional<std::string> rules{};     ///< a rule pack, whose clauses on plans are judged, too
  bool json = false;
};

/// Says whether the plan may fly: by the rules on its own numbers, and, where a rocket is known, by the phase margin of
/// the loop at every speed under control. Throws
/// text::Error for one that may not, and RequirementNotMet for one that a clause of the rule pack does not allow.
void check_plan(const PlanCheck& asked);

/// Clauses of ranges that a plan for a launch does not meet; a sentence each, without a full stop.
[[nodiscard]] std::vector<std::string> unmet_clauses(const core::FlightPlan& plan);

/// Every field of a plan by section and key, in the units of plan files.
[[nodiscard]] json::Value plan_json(const core::FlightPlan& plan);

}  // namespace fantail::tool
