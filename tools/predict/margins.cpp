// SPDX-License-Identifier: MIT
#include "predict/margins.hpp"

#include "stability/roll_loop.hpp"

namespace fantail::predict {
namespace {

constexpr int speeds = 33;

std::optional<MarginsAtSpeed> at_speed(const sim::Scenario& scenario, const std::vector<Run>& runs, double speed_m_s) {
  std::vector<double> phase_margins;
  std::vector<double> crossovers;
  std::vector<double> gain_margins;
  sim::Scenario flown = scenario;
  for (const Run& run : runs) {
    flown.vehicle.roll_plant.damping_m2 = run.airframe.damping_m2;
    flown.vehicle.roll_plant.torque_m = run.airframe.torque_m;
    const auto found = stability::margins(stability::loop_at_speed(flown, speed_m_s));
    if (!found) {
      return std::nullopt;
    }
    phase_margins.push_back(found->phase_margin_rad);
    crossovers.push_back(found->crossover_rad_s);
    if (found->gain_margin) {
      gain_margins.push_back(*found->gain_margin);
    }
  }
  MarginsAtSpeed all{.speed_m_s = speed_m_s,
                     .phase_margin_rad = spread(std::move(phase_margins)),
                     .crossover_rad_s = spread(std::move(crossovers))};
  if (gain_margins.size() == runs.size()) {
    all.gain_margin = spread(std::move(gain_margins));
  }
  return all;
}

}  // namespace

std::vector<MarginsAtSpeed> margins_over_speed(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                               double from_m_s, double to_m_s) {
  std::vector<MarginsAtSpeed> all;
  for (int i = 0; i < speeds; ++i) {
    const double speed_m_s = from_m_s + (to_m_s - from_m_s) * i / (speeds - 1);
    if (auto found = at_speed(scenario, runs, speed_m_s)) {
      all.push_back(*found);
    }
  }
  return all;
}

}  // namespace fantail::predict
