// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace fantail::tool {

struct PlanCheck {
  std::optional<std::string> plan{};      ///< a plan, or a scenario with a plan of its own
  std::optional<std::string> scenario{};  ///< whose rocket the plan is to fly
  bool json = false;
};

/// Says whether the plan may fly: by the rules on its own numbers, and, where a rocket is known, by the phase margin of
/// the loop at every speed under control. Throws text::Error for one that may not.
void check_plan(const PlanCheck& asked);

}  // namespace fantail::tool
