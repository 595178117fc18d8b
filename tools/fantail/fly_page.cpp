// SPDX-License-Identifier: MIT
#include "fantail/fly_page.hpp"

#include <algorithm>

#include "flight/flight.hpp"
#include "text/shell_word.hpp"

namespace fantail::tool {

std::optional<double> settles_off_rad(const sim::Scenario& scenario) {
  const core::FlightPlan& plan = scenario.plan;
  const auto& offset = scenario.disturbance;
  if (flight::rejects_offset(plan)) {
    return 0.0;
  }
  const double gain =
      static_cast<double>(plan.controller.proportional_gain) * sim::left_by_fins(scenario.vehicle.canard_air);
  const bool is_constant =
      plan.gain_schedule.speeds_count == 0 && gain > 0.0 &&
      std::ranges::all_of(offset, [&](const auto& node) { return node.angle_rad == offset.front().angle_rad; });
  return is_constant ? std::optional{offset.empty() ? 0.0 : offset.front().angle_rad / gain} : std::nullopt;
}

std::string command_of(const std::string& scenario, const std::vector<std::string>& changes) {
  std::string command = "fantail fly " + text::shell_word(scenario);
  for (const std::string& change : changes) {
    const bool is_option = change.starts_with("seed=") || change.starts_with("trajectory=");
    command += is_option ? " --" : " --set ";
    command += text::shell_word(change);
  }
  return command;
}

}  // namespace fantail::tool
