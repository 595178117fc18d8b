// SPDX-License-Identifier: MIT
#include "fly/loop_margins.hpp"

#include <algorithm>
#include <optional>

#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"

namespace fantail::fly {

std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario, std::vector<double> speeds_m_s) {
  if (speeds_m_s.empty()) {
    return {};
  }
  const double lowest_m_s = std::ranges::min(speeds_m_s);
  const double top_m_s = std::ranges::max(speeds_m_s);
  const auto middle = speeds_m_s.begin() + std::ssize(speeds_m_s) / 2;
  std::ranges::nth_element(speeds_m_s, middle);
  const double median_m_s = *middle;

  const auto at = [&scenario](double speed_m_s) -> std::optional<flight::LoopMargin> {
    const auto found = stability::margins(stability::loop_at_speed(scenario, speed_m_s));
    return found ? std::optional{flight::LoopMargin{speed_m_s, found->phase_margin_rad, found->gain_margin,
                                                    found->crossover_rad_s}}
                 : std::nullopt;
  };
  const auto worst = stability::margins_in_range(scenario, {lowest_m_s, top_m_s}).least;
  const double worst_m_s = worst ? worst->speed_m_s : lowest_m_s;
  std::vector<flight::LoopMargin> all;
  for (const double speed_m_s : {lowest_m_s, median_m_s, top_m_s, worst_m_s}) {
    const auto found = at(speed_m_s);
    const auto known = [&](const flight::LoopMargin& other) { return other.speed_m_s == found->speed_m_s; };
    if (found && std::ranges::none_of(all, known)) {
      all.push_back(*found);
    }
  }
  std::ranges::sort(all, {}, &flight::LoopMargin::speed_m_s);
  return all;
}

}  // namespace fantail::fly
