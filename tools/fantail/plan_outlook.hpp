// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "json/value.hpp"
#include "sim/scenario.hpp"

namespace fantail::tool {

/// What a plan's gate and capture will do.
struct GateCheck {
  std::string sentence{};  ///< empty: no scenario, or no gate beyond the guide that opens in it
  std::vector<std::string> warnings{};
  json::Value json{};  ///< null without a scenario
};

[[nodiscard]] GateCheck check_gate(const core::FlightPlan& plan, const std::optional<sim::Scenario>& scenario);

}  // namespace fantail::tool
