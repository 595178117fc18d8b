// SPDX-License-Identifier: MIT
#include "predict/loop_at_speed.hpp"

#include <cmath>

namespace fantail::predict {
namespace {

constexpr int speeds = 33;
constexpr double tick_s = 1e-3;

std::optional<MarginsAtSpeed> at_speed(const sim::Scenario& scenario, const std::vector<Run>& runs, double speed_m_s) {
  std::vector<double> phase_margins;
  std::vector<double> crossovers;
  std::vector<double> gain_margins;
  for (const Run& run : runs) {
    const std::optional<Margins> found = margins(loop_at_speed(scenario, run.airframe, speed_m_s));
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

double loop_delay_s(const sim::Vehicle& vehicle) {
  // A pulse is as old as half a tick when its frame begins, in the mean, and then stands for a frame: half of it late.
  return vehicle.imu.delay_s + 0.5 * tick_s + 0.5 * vehicle.servo.frame_period_s + vehicle.servo.delay_s;
}

RollLoop loop_at_speed(const sim::Scenario& scenario, const TunnelStep& airframe, double speed_m_s) {
  sim::RollPlant plant = scenario.vehicle.roll_plant;
  plant.damping_m2 = airframe.damping_m2;
  plant.torque_m = airframe.torque_m;
  const double density_kg_m3 = scenario.atmosphere.density_kg_m3(0.0);
  return {.proportional_gain = static_cast<double>(scenario.plan.controller.proportional_gain),
          .derivative_gain_s = static_cast<double>(scenario.plan.controller.derivative_gain_s),
          .damping_rate_per_s = plant.damping_rate_per_s(density_kg_m3, speed_m_s),
          .authority_per_s2 = plant.authority_per_s2(density_kg_m3, speed_m_s),
          .servo_lag_s = scenario.vehicle.servo.lag_s,
          .delay_s = loop_delay_s(scenario.vehicle)};
}

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
