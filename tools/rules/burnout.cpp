// SPDX-License-Identifier: MIT
#include "rules/burnout.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "rules/record.hpp"
#include "sim/units.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

constexpr double window_s = 0.1;
constexpr double threshold_m_s2 = 0.15 * sim::gravity_m_s2;

double pushed_until_s(std::span<const flight::Row> ascent) {
  double last_s = 0.0;
  std::size_t first = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < ascent.size(); ++i) {
    sum += ascent[i].specific_force_m_s2;
    while (ascent[i].time_s - ascent[first].time_s > window_s) {
      sum -= ascent[first++].specific_force_m_s2;
    }
    if (ascent[i].time_s >= 0.0 && sum >= threshold_m_s2 * static_cast<double>(i - first + 1)) {
      last_s = ascent[i].time_s;
    }
  }
  return last_s;
}

/// Whoever wrote the plan may have been wrong.
std::string stated_burn(const flight::Flight& flight) {
  const auto burn_time_s = static_cast<double>(core::seconds(flight.plan.dormancy.burn_time));
  return flight.known.plan && burn_time_s > 0.0
             ? fmt::format("; dormancy.burn_time_s = {} is the plan's word, not verified", text::brief(burn_time_s, 3))
             : "";
}

}  // namespace

Finding burnout_s(const flight::Flight& flight, std::span<const flight::Row> ascent, const Recorded& recorded,
                  const std::optional<double>& motor_burns_s) {
  if (const auto& known_s = flight.events.burnout_s) {
    const bool is_bound = flight.path_frame == flight::PathFrame::plane;
    return {Number{*known_s, is_bound ? infinity : *known_s},
            is_bound ? "the trajectory does not show thrust below drag" : ""};
  }
  const double last_s = pushed_until_s(ascent);
  const bool is_cut = ascent.back().time_s - last_s <= window_s;
  const std::string seen = fmt::format("the axial force was last above 0.15 g at {} s", text::fixed(last_s, 2));
  const double end_s = std::max(last_s, motor_burns_s.value_or(0.0));
  const std::vector<Hole> hidden =
      recorded.is_log ? holes(flight.rows, 0.0, end_s + 2.0 * longest_step_s) : std::vector<Hole>{};
  if (!hidden.empty()) {
    return {Number{last_s, infinity}, with_missing(seen, hidden)};
  }
  if (motor_burns_s && !is_cut) {
    return {exactly(end_s),
            fmt::format("{}; by its thrust curve the motor burns for {} s", seen, text::fixed(*motor_burns_s, 2))};
  }
  return {Number{last_s, infinity},
          seen +
              (is_cut ? fmt::format(", where the {} ends", recorded.is_whole ? "ascent" : "record")
                      : "; thrust below drag may last longer") +
              stated_burn(flight)};
}

}  // namespace fantail::rules
