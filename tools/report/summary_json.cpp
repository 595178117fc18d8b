// SPDX-License-Identifier: MIT
#include "report/summary_json.hpp"

#include "json/value.hpp"
#include "report/sha256.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

using Json = json::Value;
using json::rounded;
using json::text_or_null;

Json angle(const std::optional<double>& radians) { return radians ? rounded(text::degrees(*radians)) : Json{}; }

Json events(const flight::Events& e) {
  return {{"liftoff_s", rounded(e.liftoff_s)},
          {"detected_s", rounded(e.detected_s)},
          {"guide_clear_s", rounded(e.guide_clear_s)},
          {"control_start_s", rounded(e.control_start_s)},
          {"burnout_s", rounded(e.burnout_s)},
          {"control_end_s", rounded(e.control_end_s)},
          {"apogee_s", rounded(e.apogee_s)}};
}

Json phase_changes(const flight::Flight& flight) {
  Json all = Json::array();
  for (const flight::PhaseChange& change : flight.phase_changes) {
    all.push_back({{"time_s", rounded(change.time_s)},
                   {"phase", core::name(change.phase)},
                   {"reason", change.reason ? Json(core::name(*change.reason)) : Json{}}});
  }
  return all;
}

Json canard_verdicts(const flight::Flight& flight) {
  Json all = Json::array();
  for (const flight::CanardVerdictChange& change : flight.canard_verdict_changes) {
    all.push_back(
        {{"time_s", rounded(change.time_s)}, {"canard", change.canard + 1}, {"verdict", core::name(change.verdict)}});
  }
  return all;
}

Json imposed_roll(const flight::Flight& flight) {
  if (!flight.imposed_roll) {
    return {};
  }
  return {{"time_s", rounded(flight.imposed_roll->time_s)},
          {"angle_deg", rounded(text::degrees(flight.imposed_roll->angle_rad))},
          {"rate_deg_s", rounded(text::degrees(flight.imposed_roll->rate_rad_s))}};
}

}  // namespace

std::string summary_json(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  const Json summary = {{"scenario", flight.scenario},
                        {"vehicle", text_or_null(flight.vehicle)},
                        {"plan", text_or_null(flight.plan_name)},
                        {"seed", flight.seed},
                        {"verdict", verdict.text},
                        {"outcome", name(verdict.outcome)},
                        {"events", events(flight.events)},
                        {"apogee_m", rounded(figures.apogee_m)},
                        {"max_speed_m_s", rounded(figures.max_speed_m_s)},
                        {"control_start_height_m", rounded(figures.control_start_height_m)},
                        {"control_time_s", rounded(figures.control_time_s)},
                        {"saturated_fraction", rounded(figures.saturated_fraction)},
                        {"largest_hold_error_deg", angle(figures.largest_hold_error_rad)},
                        {"mean_hold_error_deg", angle(figures.mean_hold_error_rad)},
                        {"largest_disturbance_deg", angle(figures.largest_disturbance_rad)},
                        {"authority_margin_deg", angle(figures.authority_margin_rad)},
                        {"roll_turns", rounded(figures.roll_turns)},
                        {"at_limit_since_s", rounded(figures.at_limit_since_s)},
                        {"final_phase", flight.known.phase ? Json(core::name(figures.final_phase)) : Json{}},
                        {"phase_changes", phase_changes(flight)},
                        {"canard_verdicts", canard_verdicts(flight)},
                        {"imposed_roll", imposed_roll(flight)},
                        {"notes", flight.notes},
                        {"log_sha256", flight.log.empty() ? Json{} : Json(sha256(flight.log))},
                        {"version", text_or_null(flight.version)}};
  return summary.pretty();
}

}  // namespace fantail::report
