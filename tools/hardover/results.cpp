// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "hardover/study.hpp"
#include "json/value.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::hardover {
namespace {

using text::degrees;
using text::fixed;

std::string what_fails(const Study& study) {
  return study.options.failure == Failure::hard_over
             ? fmt::format("that runs to its stop of {} deg", fixed(degrees(study.stop_rad), 0))
             : fmt::format("whose pulses are cut off for {} ms", fixed(1e3 * cut_s, 0));
}

/// The worst of all canards and instants in one sentence.
std::string headline(const Study& study) {
  const Effect worst = study.worst();
  const std::string moment = worst.moment_n_m
                                 ? fmt::format(" and bends it at {} m by up to {} N m",
                                               fixed(*study.options.coupler_m, 2), fixed(*worst.moment_n_m, 2))
                                 : "";
  return fmt::format(
      "One canard {} pushes this rocket to the side by up to {} N{}, turns its way by up to {} deg and moves its "
      "apogee by "
      "up to {} m over ground, to a height of {} m at the lowest; the sound rocket reaches {} m.",
      what_fails(study), fixed(worst.side_force_n, 1), moment, fixed(degrees(worst.turned_rad), 1),
      fixed(worst.away_m, 0), fixed(worst.apogee_m, 0), fixed(study.sound_apogee_m, 0));
}

std::vector<std::string> remarks(const Study& study) {
  return {
      fmt::format("{} flights in six degrees of freedom: each of four canards failed every {} s from the end of the "
                  "guide, {} s "
                  "after ignition, to apogee at {} s. The other three go on controlling, by the real avionics.",
                  study.effects.size(), fixed(study.options.step_s, 2), fixed(study.first_s, 2),
                  fixed(study.last_s, 2)),
      fmt::format("Side force: 1/2 rho v^2 times {:.4g} m2 times the sum of the four deflections as vectors across the "
                  "axis, at "
                  "{} m from the tip of the nose. {}",
                  study.side_area_m2, fixed(study.position_m, 3),
                  study.stall_rad ? fmt::format("Lift grows with the angle up to the stall at {} deg.",
                                                fixed(degrees(*study.stall_rad), 0))
                                  : "The vehicle states no stall, so that lift grows with the angle up to the stop."),
      "Bending moment: side force of the canards times its distance to the station. The inertia of what lies in front "
      "of it takes "
      "some of that off, and the lift of the nose at an angle of attack is not in it.",
      fmt::format(
          "The angle of attack of the sound rocket is up to {} deg in the same wind, while it is faster than {} m/s.",
          fixed(degrees(study.sound_angle_of_attack_rad), 1), fixed(slowest_m_s, 0)),
      "How far it drifts under a parachute is the same as for the sound rocket, from another apogee. A rocket that "
      "breaks is not "
      "in here.",
  };
}

std::vector<const Effect*> of_canard(const Study& study, std::size_t canard) {
  std::vector<const Effect*> list;
  for (const Effect& one : study.effects) {
    if (one.canard == canard) {
      list.push_back(&one);
    }
  }
  return list;
}

page::Chart chart(const Study& study, std::string label, double (*value)(const Effect&)) {
  page::Chart chart{
      .label = label, .x_label = "canard fails, s after ignition", .y_label = label, .width = page::half_page};
  constexpr std::array roles{page::Role::measured, page::Role::model, page::Role::second_model, page::Role::target};
  for (std::size_t canard = 0; canard < roles.size(); ++canard) {
    page::Series series{.name = fmt::format("canard {}", canard + 1), .role = roles[canard]};
    for (const Effect* one : of_canard(study, canard)) {
      series.x.push_back(one->from_s);
      series.y.push_back(value(*one));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string table(const Study& study) {
  const std::array<page::Column, 8> columns{{{"fails at, s", true},
                                             {"canard", true},
                                             {"side force, N", true},
                                             {"bending, N m", true},
                                             {"attack, deg", true},
                                             {"turned, deg", true},
                                             {"apogee, m", true},
                                             {"moved, m", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Effect& one : study.effects) {
    rows.push_back({{fixed(one.from_s, 2)},
                    {fmt::format("{}", one.canard + 1)},
                    {fixed(one.side_force_n, 2)},
                    {one.moment_n_m ? fixed(*one.moment_n_m, 2) : "not asked"},
                    {fixed(degrees(one.angle_of_attack_rad), 1)},
                    {fixed(degrees(one.turned_rad), 1)},
                    {fixed(one.apogee_m, 0)},
                    {fixed(one.away_m, 1)}});
  }
  return page::table(columns, rows);
}

json::Value json(const Effect& one) {
  return {{"canard", one.canard + 1},
          {"from_s", json::rounded(one.from_s)},
          {"side_force_n", json::rounded(one.side_force_n)},
          {"dynamic_pressure_pa", json::rounded(one.pressure_pa)},
          {"moment_n_m", json::Value{json::rounded(one.moment_n_m)}},
          {"angle_of_attack_deg", json::rounded(degrees(one.angle_of_attack_rad))},
          {"way_turned_deg", json::rounded(degrees(one.turned_rad))},
          {"apogee_m", json::rounded(one.apogee_m)},
          {"apogee_moved_m", json::rounded(one.away_m)}};
}

}  // namespace

std::string study_text(const Study& study) {
  std::string text = headline(study) + "\n";
  for (const std::string& remark : remarks(study)) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string study_json(const Study& study) {
  json::Value effects = json::Value::array();
  for (const Effect& one : study.effects) {
    effects.push_back(json(one));
  }
  const Effect worst = study.worst();
  const json::Value all = {{"scenario", study.scenario},
                           {"vehicle", study.vehicle},
                           {"failure", study.options.failure == Failure::hard_over ? "hard_over" : "cut_pulses"},
                           {"canard_side_area_m2", json::rounded(study.side_area_m2)},
                           {"canard_position_m", json::rounded(study.position_m)},
                           {"stop_deg", json::rounded(degrees(study.stop_rad))},
                           {"sound_apogee_m", json::rounded(study.sound_apogee_m)},
                           {"worst",
                            {{"side_force_n", json::rounded(worst.side_force_n)},
                             {"moment_n_m", json::Value{json::rounded(worst.moment_n_m)}},
                             {"angle_of_attack_deg", json::rounded(degrees(worst.angle_of_attack_rad))},
                             {"way_turned_deg", json::rounded(degrees(worst.turned_rad))},
                             {"lowest_apogee_m", json::rounded(worst.apogee_m)},
                             {"apogee_moved_m", json::rounded(worst.away_m)}}},
                           {"effects", effects}};
  return all.pretty();
}

std::string study_html(const Study& study) {
  const std::array<std::string, 2> first{
      page::figure(chart(study, "side force / N", [](const Effect& e) { return e.side_force_n; })),
      page::figure(chart(study, "way turned / deg", [](const Effect& e) { return degrees(e.turned_rad); }))};
  const std::array<std::string, 2> second{
      page::figure(chart(study, "apogee moved over ground / m", [](const Effect& e) { return e.away_m; })),
      page::figure(chart(study, "apogee / m", [](const Effect& e) { return e.apogee_m; }))};
  return page::html(
      {.kind = "Fantail: one canard that fails",
       .title = study.scenario,
       .subtitle = study.vehicle,
       .verdict_heading = "At worst",
       .verdict = headline(study),
       .body_html = page::section("When it fails", page::side_by_side(first) + page::side_by_side(second)) +
                    page::section("How this is known", page::list(remarks(study))) +
                    page::section("Every flight", table(study))});
}

}  // namespace fantail::hardover
