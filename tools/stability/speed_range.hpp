// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/scenario.hpp"

namespace fantail::stability {

/// Air speeds at which a loop is closed.
struct SpeedRange {
  double lowest_m_s = 0.0;
  double highest_m_s = 0.0;
};

/// So many equal steps from end to end, and the rows of the plan's gain schedule that lie between: there its factor has
/// a corner. Increasing.
[[nodiscard]] std::vector<double> speeds_between(const core::FlightPlan& plan, const SpeedRange& range, int steps);

struct MarginAtSpeed {
  double speed_m_s = 0.0;
  double phase_margin_rad = 0.0;
};

/// The phase margins of a scenario's loop, looked at every half metre a second or closer.
struct MarginsInRange {
  std::optional<MarginAtSpeed> least{};          ///< empty: the gain reaches one at no speed, so nothing swings
  std::optional<MarginAtSpeed> first_without{};  ///< the lowest speed at which the loop is unstable
};

[[nodiscard]] MarginsInRange margins_in_range(const sim::Scenario& scenario, const SpeedRange& range);

/// What a plan may say, in SI and radians.
struct PlanRange {
  double minimum = 0.0;
  double maximum = 0.0;
};

/// Of a field of the plan. Throws std::logic_error for one that is not there.
[[nodiscard]] PlanRange plan_range(std::string_view section, std::string_view key);

}  // namespace fantail::stability
