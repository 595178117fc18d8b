// SPDX-License-Identifier: MIT
#include "predict/authority_over_speed.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/canard_aerodynamics.hpp"
#include "sim/shaft_load.hpp"

namespace fantail::predict {
namespace {

constexpr double steps_of_speed = 100.0;

double given_rad(const sim::Scenario& scenario, double reach_rad, double speed_m_s) {
  const sim::Vehicle& vehicle = scenario.vehicle;
  if (!vehicle.servo.torque_n_m || !vehicle.canard_air.hinge_moment_m3) {
    return reach_rad;
  }
  const double pressure_pa = 0.5 * scenario.atmosphere.density_kg_m3(0.0) * speed_m_s * speed_m_s;
  const double moment_n_m_rad = std::abs(pressure_pa * *vehicle.canard_air.hinge_moment_m3);
  const double held_rad = sim::left_by_fins(vehicle.canard_air) * *vehicle.servo.torque_n_m / moment_n_m_rad;
  return moment_n_m_rad > 0.0 ? std::min(reach_rad, held_rad) : reach_rad;
}

}  // namespace

std::vector<SpeedAt> climb(const sim::Scenario& scenario, const Run& run) {
  const flight::Flight flight = fly_airframe(scenario, run.airframe, run.seed, fly::Log::kept);
  if (!flight.events.liftoff_s) {
    return {};
  }
  std::vector<SpeedAt> all;
  for (const flight::Row& row : flight.rows) {
    const bool is_faster =
        row.truth && (all.empty() || row.truth->speed_m_s > all.back().speed_m_s + run.top_speed_m_s / steps_of_speed);
    if (is_faster && row.time_s >= *flight.events.liftoff_s) {
      all.push_back({row.time_s - *flight.events.liftoff_s, row.truth->speed_m_s});
    }
  }
  return all;
}

std::vector<AuthorityAtSpeed> authority_over_speed(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                                   const std::vector<SpeedAt>& climb, double reach_rad) {
  std::vector<AuthorityAtSpeed> all;
  for (const SpeedAt& at : climb) {
    std::vector<double> needed_rad;
    std::ranges::transform(runs, std::back_inserter(needed_rad),
                           [&at](const Run& run) { return std::abs(offset_rad(run.airframe, at.after_liftoff_s)); });
    all.push_back({.speed_m_s = at.speed_m_s,
                   .needed_rad = campaign::quantiles(std::move(needed_rad)),
                   .given_rad = given_rad(scenario, reach_rad, at.speed_m_s)});
  }
  return all;
}

}  // namespace fantail::predict
