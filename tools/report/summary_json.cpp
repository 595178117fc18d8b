// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "json/value.hpp"
#include "report/results.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/sha256.hpp"

namespace fantail::report {
namespace {

using Json = json::Value;
using json::rounded;
using json::text_or_null;

Json angle(const std::optional<double>& radians) { return radians ? rounded(text::degrees(*radians)) : Json{}; }

Json events(const flight::Events& events) {
  Json all;
  for (const auto& [name, time_s] : flight::named_events) {
    all[name] = rounded(events.*time_s);
  }
  return all;
}

/// About each body axis, the long one first.
Json gyro_bias(const flight::Flight& flight) {
  if (!flight.gyro_bias_rad_s) {
    return {};
  }
  Json all = Json::array();
  for (const float rad_s : {flight.gyro_bias_rad_s->x, flight.gyro_bias_rad_s->y, flight.gyro_bias_rad_s->z}) {
    all.push_back(rounded(text::degrees(static_cast<double>(rad_s))));
  }
  return all;
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

Json oscillation(const std::optional<Oscillation>& found) {
  if (!found) {
    return {};
  }
  return {{"from_s", rounded(found->from_s)},
          {"frequency_hz", rounded(found->frequency_hz)},
          {"lowest_deg", rounded(text::degrees(found->lowest_rad))},
          {"highest_deg", rounded(text::degrees(found->highest_rad))}};
}

Json side_deflection(const std::optional<SideDeflection>& side) {
  if (!side) {
    return {};
  }
  return {{"largest_deg", rounded(text::degrees(side->largest_rad))},
          {"mean_deg", rounded(text::degrees(side->mean_rad))},
          {"largest_moment_n_m", rounded(side->largest_moment_n_m)}};
}

Json loop_margins(const flight::Flight& flight) {
  Json all = Json::array();
  for (const flight::LoopMargin& margin : flight.loop_margins) {
    all.push_back({{"speed_m_s", rounded(margin.speed_m_s)},
                   {"phase_margin_deg", rounded(text::degrees(margin.phase_margin_rad))},
                   {"gain_margin", rounded(margin.gain_margin)},
                   {"crossover_rad_s", rounded(margin.crossover_rad_s)}});
  }
  return all;
}

Json canard_reach(const flight::Flight& flight) {
  const auto& reach = flight.canard_reach;
  return reach ? Json{{"lowest", rounded(text::degrees(reach->lowest_rad))},
                      {"highest", rounded(text::degrees(reach->highest_rad))}}
               : Json{};
}

Json wind(const flight::Flight& flight) {
  return flight.wind ? Json{{"speed_m_s", rounded(flight.wind->speed_m_s)},
                            {"from_deg", rounded(text::degrees(flight.wind->from_rad))},
                            {"height_m", rounded(flight.wind->height_m)}}
                     : Json{};
}

Json unmeasured(const flight::Unmeasured& u) {
  return {{"spin_from_s", rounded(u.spin_from_s)},
          {"spin_for_s", rounded(u.spin_for_s)},
          {"spin_deg_s", rounded(text::degrees(u.spin_rad_s))},
          {"silent_from_s", rounded(u.silent_from_s)},
          {"silent_for_s", rounded(u.silent_for_s)},
          {"speed_bound_from_s", rounded(u.speed_bound_from_s)}};
}

Json outage_list(const flight::Flight& flight) {
  Json all = Json::array();
  for (const flight::Outage& outage : flight.outages) {
    all.push_back({{"from_s", rounded(outage.from_s)},
                   {"to_s", rounded(outage.to_s)},
                   {"cause", outage.cause},
                   {"resumed", outage.resumed}});
  }
  return all;
}

/// Of a flight with a path, at apogee.
Json path(const flight::Flight& flight) {
  const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value_or(-1.0));
  if (top != nullptr && flight.path_frame == flight::PathFrame::plane) {
    return {{"across_m", rounded(top->north_m)},
            {"height_m", rounded(top->height_m)},
            {"tilt_deg", rounded(text::degrees(top->tilt_rad))}};
  }
  return top != nullptr ? Json{{"north_m", rounded(top->north_m)},
                               {"east_m", rounded(top->east_m)},
                               {"height_m", rounded(top->height_m)},
                               {"tilt_deg", rounded(text::degrees(top->tilt_rad))}}
                        : Json{};
}

/// Only where the vehicle has it.
void add_course(Json& summary, const flight::FlownAirframe& airframe) {
  if (airframe.grows_with_mach) {
    summary["compressibility"] = "prandtl_glauert";
  }
  Json course = Json::array();
  for (const auto& [time_s, inertia_kg_m2] : airframe.roll_inertia_course) {
    course.push_back({{"time_s", rounded(time_s)}, {"kg_m2", inertia_kg_m2}});
  }
  if (!airframe.roll_inertia_course.empty()) {
    summary["roll_inertia_course"] = course;
  }
}

}  // namespace

std::string summary_json(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                         const result::Made& made) {
  Json summary = {{"scenario", flight.scenario},
                  {"vehicle", text_or_null(flight.vehicle)},
                  {"vehicle_file", flight.airframe ? Json(flight.airframe->vehicle_file) : Json{}},
                  {"roll_inertia_kg_m2", flight.airframe ? Json(flight.airframe->roll_inertia_kg_m2) : Json{}},
                  {"reference_area_m2", flight.airframe ? Json(flight.airframe->reference_area_m2) : Json{}},
                  {"plan", text_or_null(flight.plan_name)},
                  {"seed", flight.seed},
                  {"changes", flight.changes},
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
                  {"judged_time_s", rounded(figures.judged_time_s)},
                  {"rest_error_deg", angle(figures.rest_error_rad)},
                  {"mean_reference_error_deg", angle(figures.mean_reference_error_rad)},
                  {"rest_limit_deg", rounded(text::degrees(flight.rest_limit_rad))},
                  {"top_mach", rounded(flight.extremes.top_mach)},
                  {"static_margin_calibres", rounded(flight.extremes.static_margin_calibres)},
                  {"angle_of_attack_deg", angle(flight.extremes.angle_of_attack_rad)},
                  {"largest_disturbance_deg", angle(figures.largest_disturbance_rad)},
                  {"authority_deg", angle(figures.authority_rad)},
                  {"authority_margin_deg", angle(figures.authority_margin_rad)},
                  {"ended_before_apogee_s", rounded(figures.ended_before_apogee_s)},
                  {"roll_after_end_deg", angle(figures.roll_after_end_rad)},
                  {"oscillation", oscillation(figures.oscillation)},
                  {"canard_side_deflection", side_deflection(figures.side_deflection)},
                  {"canard_side_moment_m3", flight.side_moment_m3},
                  {"loop_margins", loop_margins(flight)},
                  {"canard_reach_deg", canard_reach(flight)},
                  {"why_uncontrollable", flight.why_uncontrollable},
                  {"left_by_fins", rounded(flight.left_by_fins)},
                  {"unmeasured", unmeasured(flight.unmeasured)},
                  {"wind", wind(flight)},
                  {"at_apogee", path(flight)},
                  {"roll_turns", rounded(figures.roll_turns)},
                  {"roll_turns_without_control", rounded(figures.roll_turns_without_control)},
                  {"at_limit_since_s", rounded(figures.at_limit_since_s)},
                  {"final_phase", flight.known.phase ? Json(core::name(figures.final_phase)) : Json{}},
                  {"phase_changes", phase_changes(flight)},
                  {"gyro_bias_deg_s", gyro_bias(flight)},
                  {"canard_verdicts", canard_verdicts(flight)},
                  {"imposed_roll", imposed_roll(flight)},
                  {"why_not_armed", text_or_null(flight.why_not_armed)},
                  {"notes", flight.notes},
                  {"log_sha256", flight.log.empty() ? Json{} : Json(text::sha256(flight.log))},
                  {"version", text_or_null(flight.version)}};
  if (flight.airframe) {
    add_course(summary, *flight.airframe);
  }
  if (flight.trajectory_end_s) {
    summary["trajectory_end_s"] = rounded(*flight.trajectory_end_s);
  }
  if (const auto& camera = figures.camera_roll) {
    summary["camera_roll"] = {{"largest_apart_deg", rounded(text::degrees(camera->largest_rad))},
                              {"at_end_apart_deg", rounded(text::degrees(camera->at_end_rad))}};
  }
  if (flight.before_burnout) {
    summary["before_burnout"] = before_burnout_json(flight);
  }
  if (!flight.outages.empty()) {
    summary["outages"] = outage_list(flight);
  }
  json::keep_exact(summary, "seed");
  result::put_answer(summary, answer(verdict), verdict.text, made);
  return summary.pretty();
}

}  // namespace fantail::report
