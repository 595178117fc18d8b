// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/core.h>

#include "brief/brief.hpp"
#include "campaign/flown_run.hpp"
#include "flight/model_end.hpp"
#include "report/verdict.hpp"
#include "text/number.hpp"

namespace fantail::brief {
namespace {

constexpr std::array directions_rad{0.0, 0.5 * std::numbers::pi, std::numbers::pi, 1.5 * std::numbers::pi};

/// A clause; empty: nothing.
std::string what_fails(const sim::Scenario& scenario, const campaign::JudgedFlight& flown) {
  if (flown.verdict.outcome == report::Outcome::ascent_failed || !flown.flight.events.apogee_s) {
    return "the ascent fails";
  }
  if (std::string beyond = flight::how_far_beyond(flown.flight.extremes); !beyond.empty()) {
    return "the flight is outside the roll model: " + beyond;
  }
  if (flown.verdict.ended_by_tilt) {
    return fmt::format("the tilt limit ends control more than {} s before apogee",
                       text::brief(scenario.tilt_end_before_apogee_s, 2));
  }
  return flown.flight.events.control_start_s ? "" : "control does not begin";
}

double at_guide_exit_rad(const flight::Flight& flight) {
  const auto& clear_s = flight.events.guide_clear_s;
  const flight::PathPoint* const at = clear_s ? flight::point_at(flight.path, *clear_s) : nullptr;
  return at == nullptr ? 0.0 : at->angle_of_attack_rad;
}

}  // namespace

WindLimit wind_limit(const sim::Scenario& scenario, const std::function<void()>& look) {
  sim::Scenario tried = scenario;
  WindLimit limit{.tilt_end_before_apogee_s = scenario.tilt_end_before_apogee_s};
  for (double wind_m_s = 0.0; wind_m_s <= most_wind_m_s; wind_m_s += wind_step_m_s) {
    tried.wind.speed_m_s = wind_m_s;
    double exit_attack_rad = limit.exit_attack_rad;
    for (const double direction_rad : directions_rad) {
      tried.wind.from_rad = scenario.guide.azimuth_rad + direction_rad;
      look();
      const campaign::JudgedFlight flown = campaign::fly_and_judge(tried);
      if (const std::string why = what_fails(tried, flown); !why.empty()) {
        limit.first_failure = wind_m_s == 0.0 ? why : fmt::format("at {} m/s {}", text::brief(wind_m_s, 0), why);
        return limit;
      }
      exit_attack_rad = std::max(exit_attack_rad, at_guide_exit_rad(flown.flight));
    }
    limit.passed_m_s = wind_m_s;
    limit.exit_attack_rad = exit_attack_rad;
  }
  return limit;
}

}  // namespace fantail::brief
