// SPDX-License-Identifier: MIT
#include "fantail/fly_page.hpp"

#include <algorithm>

#include "flight/flight.hpp"
#include "stability/canard_sense.hpp"

namespace fantail::tool {

std::optional<double> settles_off_rad(const sim::Scenario& scenario) {
  const core::FlightPlan& plan = scenario.plan;
  const auto& offset = scenario.disturbance;
  if (flight::rejects_offset(plan)) {
    return 0.0;
  }
  const double gain = static_cast<double>(plan.controller.proportional_gain) * stability::left_in_the_end(scenario);
  const bool is_constant =
      plan.gain_schedule.speeds_count == 0 && gain > 0.0 &&
      std::ranges::all_of(offset, [&](const auto& node) { return node.angle_rad == offset.front().angle_rad; });
  return is_constant ? std::optional{offset.empty() ? 0.0 : offset.front().angle_rad / gain} : std::nullopt;
}

}  // namespace fantail::tool
