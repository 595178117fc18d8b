// SPDX-License-Identifier: MIT
#include "stability/speed_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "core/flight_plan_fields.hpp"
#include "stability/roll_loop.hpp"

namespace fantail::stability {

PlanRange plan_range(std::string_view section, std::string_view key) {
  for (const core::PlanField& field : core::flight_plan_fields()) {
    if (field.section == section && field.key == key) {
      return {.minimum = static_cast<double>(field.minimum * field.scale),
              .maximum = static_cast<double>(field.maximum * field.scale)};
    }
  }
  throw std::logic_error{"a plan has no " + std::string{section} + "." + std::string{key}};
}

std::vector<double> speeds_between(const core::FlightPlan& plan, const SpeedRange& range, int steps) {
  const double width_m_s = range.highest_m_s - range.lowest_m_s;
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    all.push_back(range.lowest_m_s + width_m_s * i / steps);
  }
  for (std::size_t row = 0; row < plan.gain_schedule.speeds_count; ++row) {
    const auto speed_m_s = static_cast<double>(plan.gain_schedule.speeds_m_s[row]);
    if (speed_m_s > range.lowest_m_s && speed_m_s < range.highest_m_s) {
      all.push_back(speed_m_s);
    }
  }
  std::ranges::sort(all);
  const auto [first, last] = std::ranges::unique(all);
  all.erase(first, last);
  return all;
}

MarginsInRange margins_in_range(const sim::Scenario& scenario, const SpeedRange& range) {
  const int steps = std::max(32, static_cast<int>(std::ceil(2.0 * (range.highest_m_s - range.lowest_m_s))));
  MarginsInRange found;
  for (const double speed_m_s : speeds_between(scenario.plan, range, steps)) {
    const auto margin_rad = phase_margin_rad(loop_at_speed(scenario, speed_m_s));
    if (!margin_rad) {
      continue;
    }
    const MarginAtSpeed here{.speed_m_s = speed_m_s, .phase_margin_rad = *margin_rad};
    if (!found.least || *margin_rad < found.least->phase_margin_rad) {
      found.least = here;
    }
    if (*margin_rad <= 0.0 && !found.first_without) {
      found.first_without = here;
    }
  }
  return found;
}

}  // namespace fantail::stability
