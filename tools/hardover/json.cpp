// SPDX-License-Identifier: MIT
#include <optional>

#include "hardover/study.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"

namespace fantail::hardover {
namespace {

using text::degrees;

std::optional<double> in_degrees(const std::optional<double>& angle_rad) {
  return angle_rad ? std::optional{degrees(*angle_rad)} : std::nullopt;
}

json::Value json(const Effect& one) {
  return {{"canard", one.canard + 1},
          {"stop_deg", json::rounded(degrees(one.stop_rad))},
          {"from_s", json::rounded(one.from_s)},
          {"side_force_n", json::rounded(one.side_force_n)},
          {"dynamic_pressure_pa", json::rounded(one.pressure_pa)},
          {"moment_n_m", json::Value{json::rounded(one.moment_n_m)}},
          {"angle_of_attack_deg", json::Value{json::rounded(in_degrees(one.angle_of_attack_rad))}},
          {"rolled_deg", json::rounded(degrees(one.rolled_rad))},
          {"roll_rate_deg_s", json::rounded(degrees(one.roll_rate_rad_s))},
          {"way_turned_deg", json::rounded(degrees(one.turned_rad))},
          {"apogee_m", json::rounded(one.apogee_m)},
          {"apogee_moved_m", json::rounded(one.away_m)}};
}

}  // namespace

std::string_view name_of(core::CanardFaultPolicy policy) {
  switch (policy) {
    case core::CanardFaultPolicy::share: return "share";
    case core::CanardFaultPolicy::continue_control: return "continue";
    case core::CanardFaultPolicy::end_control: return "end_control";
  }
  return "unknown";
}

std::string study_json(const Study& study) {
  json::Value effects = json::Value::array();
  for (const Effect& one : study.effects) {
    effects.push_back(json(one));
  }
  const Effect worst = study.worst();
  json::Value all = {
      {"scenario", study.scenario},
      {"vehicle", study.vehicle},
      {"plan", study.plan},
      {"changes", study.made.changes},
      {"seed", study.seed},
      {"canard_fault", name_of(study.policy)},
      {"failure", study.options.failure == Failure::hard_over ? "hard_over" : "cut_pulses"},
      {"canard_side_area_m2", json::rounded(study.side_area_m2)},
      {"canard_position_m", json::rounded(study.position_m)},
      {"stop_deg", json::rounded(degrees(study.stop_rad))},
      {"sound_apogee_m", json::rounded(study.sound_apogee_m)},
      {"sound_angle_of_attack_deg", json::Value{json::rounded(in_degrees(study.sound_angle_of_attack_rad))}},
      {"sound_roll_rate_deg_s", json::rounded(degrees(study.sound_roll_rate_rad_s))},
      {"worst",
       {{"side_force_n", json::rounded(worst.side_force_n)},
        {"moment_n_m", json::Value{json::rounded(worst.moment_n_m)}},
        {"angle_of_attack_deg", json::Value{json::rounded(in_degrees(worst.angle_of_attack_rad))}},
        {"rolled_deg", json::rounded(degrees(worst.rolled_rad))},
        {"roll_rate_deg_s", json::rounded(degrees(worst.roll_rate_rad_s))},
        {"way_turned_deg", json::rounded(degrees(worst.turned_rad))},
        {"lowest_apogee_m", json::rounded(worst.apogee_m)},
        {"apogee_moved_m", json::rounded(worst.away_m)}}},
      {"flights", study.effects.size()},
      {"instants", study.instants},
      {"step_s", json::rounded(study.options.step_s)},
      {"coupler_m", json::Value{json::rounded(study.options.coupler_m)}},
      {"effects", effects},
      {"command", study.made.command},
      {"version", study.made.version}};
  json::keep_exact(all, "seed");
  return all.pretty();
}

}  // namespace fantail::hardover
