// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::predict {

/// How far all canards of a rocket can turn, either way, and what ends it.
struct CanardReach {
  double angle_rad = 0.0;
  std::string set_by =
      "canard limit";  ///< "canard limit", "mechanical stop of canard 2 in the plan", "servo stop", ...
};

/// The smallest of plan limit, hard limit, mechanical stop of each canard in the plan, and stop of the servo in the
/// world.
[[nodiscard]] CanardReach canard_reach(const sim::Scenario& scenario);

/// The same if the plan limit were as large as a plan may have it.
[[nodiscard]] CanardReach farthest_reach(const sim::Scenario& scenario);

}  // namespace fantail::predict
