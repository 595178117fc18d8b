// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::predict {

/// The fin offset that all canards together can balance, whichever its sense, and what ends it.
struct CanardReach {
  double angle_rad = 0.0;
  std::string set_by{};  ///< "servo stop", "mechanical stop of canard 2 in the plan", ...; empty: the plan's own limit

  /// "9 degree canard limit", "4.5 degrees that the canards reach (servo stop)".
  [[nodiscard]] std::string text() const;
};

/// As flight::authority_rad(), with the stop that the servos of this vehicle have.
[[nodiscard]] CanardReach canard_reach(const sim::Scenario& scenario);

/// The same if the plan limit were as large as a plan may have it.
[[nodiscard]] CanardReach farthest_reach(const sim::Scenario& scenario);

}  // namespace fantail::predict
