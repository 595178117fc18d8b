// SPDX-License-Identifier: MIT
#include "predict/run.hpp"

#include <algorithm>
#include <cmath>

#include "predict/canard_reach.hpp"
#include "predict/drawn_wind.hpp"
#include "report/figures.hpp"

namespace fantail::predict {
namespace {

constexpr double offset_rise_s = 1.7;
constexpr double clock_tolerance_s = 1e-6;

sim::Scenario with_airframe(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed) {
  sim::Scenario changed = scenario;
  changed.seed = seed;
  changed.vehicle.roll_plant.damping_m2 = airframe.damping_m2;
  changed.vehicle.roll_plant.torque_m = airframe.torque_m;
  changed.disturbance = {{0.0, airframe.offset_begin_rad}, {offset_rise_s, airframe.offset_end_rad}};
  changed.imposed_roll.reset();
  changed.wind = drawn_wind(scenario.wind, scenario.wind_spread, seed);
  return changed;
}

void keep_roll(Run& run, const flight::Flight& flight) {
  const double end_s = flight.events.apogee_s.value_or(flight.rows.back().time_s);
  for (const flight::Row& row : flight.rows) {
    const double next_s = track_step_s * static_cast<double>(run.roll_angle_rad.size());
    if (row.truth && row.time_s <= end_s && row.time_s >= next_s - clock_tolerance_s) {
      run.roll_angle_rad.push_back(row.truth->roll_angle_rad);
      run.roll_rate_rad_s.push_back(row.truth->roll_rate_rad_s);
      run.reference_rad.push_back(row.phase == core::Phase::controlling ? std::optional{row.reference_rad}
                                                                        : std::nullopt);
    }
  }
}

void keep_notes(Run& run, const flight::Flight& flight, const sim::Scenario& scenario) {
  const auto is_in = [](const std::vector<std::string>& all, const std::string& one) {
    return std::ranges::find(all, one) != all.end();
  };
  for (const std::string& note : flight.notes) {
    if (!is_in(scenario.assumed, note) && !is_in(scenario.vehicle.assumed, note)) {
      run.notes.push_back(note);
    }
  }
}

void keep_path(Run& run, const flight::Flight& flight, const sim::Scenario& scenario) {
  if (scenario.motion != sim::FlightMotion::six_dof) {
    return;
  }
  run.wind = drawn_wind(scenario.wind, scenario.wind_spread, run.seed);
  if (flight.events.apogee_s) {
    const flight::PathPoint* point = flight::point_at(flight.path, *flight.events.apogee_s);
    run.drift_m = point != nullptr ? std::optional{flight::distance_m(*point)} : std::nullopt;
  }
}

void look_at_control(Run& run, const flight::Flight& flight) {
  const auto is_control = [](const flight::Row& row) { return row.phase == core::Phase::controlling; };
  const auto first = std::ranges::find_if(flight.rows, is_control);
  if (first == flight.rows.end()) {
    return;
  }
  const auto last = std::find_if(flight.rows.rbegin(), flight.rows.rend(), is_control);
  run.speed_at_control_start_m_s = first->truth->speed_m_s;
  if (run.authority_margin_rad > 0.0) {
    run.settle_rad = flight::settle_point_rad(*last, flight);
  }
}

}  // namespace

std::optional<double> spin_rate_rad_s(const TunnelStep& airframe, double offset_rad, double limit_rad,
                                      double speed_m_s) {
  if (std::abs(offset_rad) <= limit_rad) {
    return std::nullopt;
  }
  const double left_rad = offset_rad - std::copysign(limit_rad, offset_rad);
  return speed_m_s * airframe.torque_m * left_rad / airframe.damping_m2;
}

flight::Flight fly_airframe(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed,
                            fly::Log log) {
  return fly::fly_scenario(with_airframe(scenario, airframe, seed), {}, {}, log);
}

Run fly_run(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed) {
  return run_of(fly_airframe(scenario, airframe, seed, fly::Log::dropped), scenario, airframe);
}

Run run_of(const flight::Flight& flight, const sim::Scenario& scenario, const TunnelStep& airframe) {
  const report::Figures figures = report::figures(flight);
  const report::Verdict verdict = report::verdict(flight, figures);
  Run run;
  run.seed = flight.seed.value_or(0);
  run.airframe = airframe;
  // The offset that is harder to balance; of two alike the larger one.
  const double begin_rad = flight::authority_margin_rad(flight, airframe.offset_begin_rad);
  const double end_rad = flight::authority_margin_rad(flight, airframe.offset_end_rad);
  run.offset_rad = begin_rad < end_rad ? airframe.offset_begin_rad : airframe.offset_end_rad;
  run.authority_margin_rad = std::min(begin_rad, end_rad);
  const double limit_rad = canard_reach(scenario, run.offset_rad).angle_rad;
  run.outcome = verdict.outcome;
  run.verdict = verdict.text;
  run.ended_early = verdict.ended_early;
  run.ended_by_tilt = verdict.ended_early && flight.phase_changes.back().reason == core::PhaseReason::tilted_too_far;
  keep_notes(run, flight, scenario);
  run.largest_hold_error_rad = figures.largest_hold_error_rad;
  run.saturated_share = figures.saturated_fraction;
  run.top_speed_m_s = figures.max_speed_m_s.value_or(0.0);
  run.apogee_m = figures.apogee_m;
  run.spin_rate_rad_s = spin_rate_rad_s(airframe, run.offset_rad, limit_rad, run.top_speed_m_s);
  keep_roll(run, flight);
  keep_path(run, flight, scenario);
  look_at_control(run, flight);
  return run;
}

}  // namespace fantail::predict
