// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::predict {

/// Angles that differ by less are the same: more than a float, as a plan has them, differs from the number.
inline constexpr double same_angle_rad = 1e-6;

/// The fin offset of one sense that all canards together can balance, and what ends it.
struct CanardReach {
  double angle_rad = 0.0;
  std::string set_by{};  ///< "servo stop", "mechanical stop of canard 2 in the plan", ...; empty: the plan's own limit

  /// "9 degree canard limit", "4.5 degrees that the canards reach (servo stop)".
  [[nodiscard]] std::string text() const;
};

/// Against an offset with this sign, with sim::deflection_range().
[[nodiscard]] CanardReach canard_reach(const sim::Scenario& scenario, double offset_rad);

/// The same if the plan limit were as large as a plan may have it.
[[nodiscard]] CanardReach farthest_reach(const sim::Scenario& scenario, double offset_rad);

}  // namespace fantail::predict
