// SPDX-License-Identifier: MIT
#include "report/summary_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"
#include "report/sha256.hpp"

namespace fantail::report {
namespace {

using Json = nlohmann::ordered_json;

// Six decimals, as in flight.csv. A number that is none becomes null by itself.
Json rounded(double value) {
  const double r = std::round(value * 1e6) / 1e6;
  return r == 0.0 ? 0.0 : r;
}
Json number(const std::optional<double>& value) { return value ? rounded(*value) : Json{}; }
Json text(const std::string& words) { return words.empty() ? Json{} : Json(words); }
Json angle(const std::optional<double>& radians) { return radians ? rounded(degrees(*radians)) : Json{}; }

Json events(const Events& e) {
  return {{"liftoff_s", number(e.liftoff_s)},
          {"detected_s", number(e.detected_s)},
          {"guide_clear_s", number(e.guide_clear_s)},
          {"control_start_s", number(e.control_start_s)},
          {"burnout_s", number(e.burnout_s)},
          {"control_end_s", number(e.control_end_s)},
          {"apogee_s", number(e.apogee_s)}};
}

Json phase_changes(const Flight& flight) {
  Json all = Json::array();
  for (const PhaseChange& change : flight.phase_changes) {
    all.push_back({{"time_s", rounded(change.time_s)},
                   {"phase", core::name(change.phase)},
                   {"reason", change.reason ? Json(core::name(*change.reason)) : Json{}}});
  }
  return all;
}

Json canard_verdicts(const Flight& flight) {
  Json all = Json::array();
  for (const CanardVerdictChange& change : flight.canard_verdict_changes) {
    all.push_back(
        {{"time_s", rounded(change.time_s)}, {"canard", change.canard + 1}, {"verdict", core::name(change.verdict)}});
  }
  return all;
}

Json imposed_roll(const Flight& flight) {
  if (!flight.imposed_roll) {
    return {};
  }
  return {{"time_s", rounded(flight.imposed_roll->time_s)},
          {"angle_deg", rounded(degrees(flight.imposed_roll->angle_rad))},
          {"rate_deg_s", rounded(degrees(flight.imposed_roll->rate_rad_s))}};
}

}  // namespace

std::string summary_json(const Flight& flight, const Figures& figures, const Verdict& verdict) {
  const Json summary = {{"scenario", flight.scenario},
                        {"vehicle", text(flight.vehicle)},
                        {"plan", text(flight.plan_name)},
                        {"seed", flight.seed ? Json(*flight.seed) : Json{}},
                        {"verdict", verdict.text},
                        {"outcome", name(verdict.outcome)},
                        {"events", events(flight.events)},
                        {"apogee_m", number(figures.apogee_m)},
                        {"max_speed_m_s", number(figures.max_speed_m_s)},
                        {"control_start_height_m", number(figures.control_start_height_m)},
                        {"control_time_s", number(figures.control_time_s)},
                        {"saturated_fraction", number(figures.saturated_fraction)},
                        {"largest_hold_error_deg", angle(figures.largest_hold_error_rad)},
                        {"mean_hold_error_deg", angle(figures.mean_hold_error_rad)},
                        {"largest_disturbance_deg", angle(figures.largest_disturbance_rad)},
                        {"authority_margin_deg", angle(figures.authority_margin_rad)},
                        {"roll_turns", number(figures.roll_turns)},
                        {"at_limit_since_s", number(figures.at_limit_since_s)},
                        {"final_phase", flight.known.phase ? Json(core::name(figures.final_phase)) : Json{}},
                        {"phase_changes", phase_changes(flight)},
                        {"canard_verdicts", canard_verdicts(flight)},
                        {"imposed_roll", imposed_roll(flight)},
                        {"notes", flight.notes},
                        {"log_sha256", flight.log.empty() ? Json{} : Json(sha256(flight.log))},
                        {"version", text(flight.version)}};
  // A scenario's name may hold any bytes; they must not turn a flown flight into an exception.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fantail::report
