// SPDX-License-Identifier: MIT
#include "predict/margins.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"

namespace fantail::predict {
namespace {

std::vector<stability::RollLoop> loops_at_speed(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                                double speed_m_s) {
  std::vector<stability::RollLoop> loops;
  sim::Scenario flown = scenario;
  for (const Run& run : runs) {
    flown.vehicle.roll_plant.damping_m2 = run.airframe.damping_m2;
    flown.vehicle.roll_plant.torque_m = run.airframe.torque_m;
    loops.push_back(stability::loop_at_speed(flown, speed_m_s));
  }
  return loops;
}

std::optional<campaign::Quantiles> spread_if_of_all(std::vector<double> values, std::size_t all) {
  return values.size() == all ? std::optional{campaign::quantiles(std::move(values))} : std::nullopt;
}

std::optional<MarginsAtSpeed> at_speed(const std::vector<stability::RollLoop>& loops, double speed_m_s) {
  std::vector<double> phase_margins;
  std::vector<double> crossovers;
  std::vector<double> gain_margins;
  for (const stability::RollLoop& loop : loops) {
    const auto found = stability::margins(loop);
    phase_margins.push_back(found ? found->phase_margin_rad : std::numbers::pi);
    if (found) {
      crossovers.push_back(found->crossover_rad_s);
    }
    if (found && found->gain_margin) {
      gain_margins.push_back(*found->gain_margin);
    }
  }
  if (crossovers.empty()) {
    return std::nullopt;
  }
  return MarginsAtSpeed{.speed_m_s = speed_m_s,
                        .phase_margin_rad = campaign::quantiles(std::move(phase_margins)),
                        .crossover_rad_s = spread_if_of_all(std::move(crossovers), loops.size()),
                        .gain_margin = spread_if_of_all(std::move(gain_margins), loops.size())};
}

}  // namespace

stability::LoopsAtSpeeds loops_at_speeds(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                         const std::vector<double>& speeds_m_s) {
  stability::LoopsAtSpeeds all;
  for (const double speed_m_s : speeds_m_s) {
    all.push_back(loops_at_speed(scenario, runs, speed_m_s));
  }
  return all;
}

std::vector<double> speeds_flown(const core::FlightPlan& plan, const std::vector<Run>& runs) {
  constexpr int steps = 32;
  std::optional<double> lowest;
  double highest = 0.0;
  for (const Run& run : runs) {
    if (run.lowest_speed_m_s) {
      lowest = std::min(lowest.value_or(*run.lowest_speed_m_s), *run.lowest_speed_m_s);
      highest = std::max(highest, run.top_speed_m_s);
    }
  }
  return lowest ? stability::speeds_between(plan, {*lowest, highest}, steps) : std::vector<double>{};
}

std::vector<MarginsAtSpeed> margins_over_speed(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                               const std::vector<double>& speeds_m_s) {
  std::vector<MarginsAtSpeed> all;
  for (const double speed_m_s : speeds_m_s) {
    if (auto found = at_speed(loops_at_speed(scenario, runs, speed_m_s), speed_m_s)) {
      all.push_back(*found);
    }
  }
  return all;
}

}  // namespace fantail::predict
