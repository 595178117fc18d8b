// SPDX-License-Identifier: MIT
#include <algorithm>
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
             ? fmt::format("that runs to a stop, at {} deg either way,", text::brief(degrees(study.stop_rad), 1))
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
      "One canard {} pushes this rocket to the side by up to {} N{}, rolls it away by up to {} deg, at up to {} deg/s, "
      "turns its way by up to {} deg and moves its apogee by up to {} m over ground, to a height of {} m at the "
      "lowest; the sound rocket reaches {} m.",
      what_fails(study), fixed(worst.side_force_n, 1), moment, fixed(degrees(worst.rolled_rad), 0),
      fixed(degrees(worst.roll_rate_rad_s), 0), fixed(degrees(worst.turned_rad), 1), fixed(worst.away_m, 0),
      fixed(worst.apogee_m, 0), fixed(study.sound_apogee_m, 0));
}

/// From how much the worst was taken.
std::string base(const Study& study) {
  constexpr std::size_t few = 20;
  return fmt::format(
      "The worst of {} flights: each of four canards{} at {} instants, every {} s from the end of the guide, {} s "
      "after ignition, to apogee at {} s.{}",
      study.effects.size(), study.options.failure == Failure::hard_over ? ", each stop," : "", study.instants,
      fixed(study.options.step_s, 2), fixed(study.first_s, 2), fixed(study.last_s, 2),
      study.instants < few ? " With so few instants what lies between them can be worse (--step)." : "");
}

std::string_view name_of(core::CanardFaultPolicy policy) {
  switch (policy) {
    case core::CanardFaultPolicy::share: return "share";
    case core::CanardFaultPolicy::continue_control: return "continue";
    case core::CanardFaultPolicy::end_control: return "end_control";
  }
  return "unknown";
}

std::string what_the_others_do(const Study& study) {
  switch (study.policy) {
    case core::CanardFaultPolicy::share:
      return "The other three go on controlling, by the real avionics, and carry what the failed one does not do, as "
             "far as their limit allows.";
    case core::CanardFaultPolicy::continue_control:
      return "The other three go on controlling, by the real avionics, as if the failed one followed.";
    case core::CanardFaultPolicy::end_control:
      return "When the avionics finds that a canard does not follow, control ends, and the other three go to trim.";
  }
  return {};
}

std::string up_to(const std::optional<double>& angle_rad) {
  return angle_rad ? fmt::format("up to {} deg", fixed(degrees(*angle_rad), 1)) : "it was never that fast";
}

std::optional<double> in_degrees(const std::optional<double>& angle_rad) {
  return angle_rad ? std::optional{degrees(*angle_rad)} : std::nullopt;
}

std::vector<std::string> remarks(const Study& study) {
  std::vector<std::string> list{
      fmt::format("Flown in six degrees of freedom with run.canard_fault = {}. {}{}", name_of(study.policy),
                  study.options.failure == Failure::hard_over
                      ? "The canard stands at its stop from one instant to the next. "
                      : "",
                  what_the_others_do(study)),
      fmt::format("Side force: 1/2 rho v^2 times {:.4g} m2 times the sum of the four deflections as vectors across the "
                  "axis, at {} m from the tip of the nose. {}",
                  study.side_area_m2, fixed(study.position_m, 3),
                  study.stall_rad ? fmt::format("Lift grows with the angle up to the stall at {} deg.",
                                                fixed(degrees(*study.stall_rad), 0))
                                  : "The vehicle states no stall, so that lift grows with the angle up to the stop."),
      fmt::format("Angle of attack while faster than {} m/s through the air, along the axis: {}; of the sound rocket "
                  "in the same "
                  "wind: {}. The sound rocket rolls at up to {} deg/s. Where the plan's tilt limit ends control, a "
                  "rocket rolls on from there.",
                  fixed(slowest_m_s, 0), up_to(study.worst().angle_of_attack_rad),
                  up_to(study.sound_angle_of_attack_rad), fixed(degrees(study.sound_roll_rate_rad_s), 0)),
      "How far it drifts under a parachute is the same as for the sound rocket, from another apogee. A rocket that "
      "breaks is not in here."};
  if (study.options.coupler_m) {
    list.push_back(*study.options.coupler_m > study.position_m
                       ? "Bending moment: side force of the canards times its distance to the station. The inertia of "
                         "what lies in front of it takes some of that off, and the lift of the nose at an angle of "
                         "attack is not in it."
                       : "The station lies in front of the canards, whose force does not bend it; the lift of the nose "
                         "at an angle of attack is not in this figure.");
  }
  return list;
}

/// "plan tasha3_launch2", ...: how somebody gets the same again.
std::vector<page::Page::Fact> facts(const Study& study) {
  std::string changes;
  for (const std::string& change : study.made.changes) {
    changes += (changes.empty() ? "" : ", ") + change;
  }
  return {{"scenario", study.scenario},
          {"plan", study.plan},
          {"changed", changes},
          {"seed", fmt::format("{}", study.seed)},
          {"version", study.made.version},
          {"command", study.made.command}};
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

double larger(double a, double b) { return std::fmax(a, b); }  // of a figure that is not known the other
double smaller(double a, double b) { return std::min(a, b); }

/// Of each canard, at the worse of its stops.
page::Chart chart(const Study& study, const std::string& label, double (*value)(const Effect&),
                  double (*worse)(double, double) = larger) {
  page::Chart chart{
      .label = label, .x_label = "canard fails, s after ignition", .y_label = label, .width = page::half_page};
  constexpr std::array roles{page::Role::measured, page::Role::model, page::Role::second_model, page::Role::target};
  for (std::size_t canard = 0; canard < roles.size(); ++canard) {
    page::Series series{.name = fmt::format("canard {}", canard + 1), .role = roles[canard]};
    const std::vector<const Effect*> flights = of_canard(study, canard);
    for (std::size_t i = 0; i < flights.size(); ++i) {
      if (i < study.instants) {
        series.x.push_back(flights[i]->from_s);
        series.y.push_back(value(*flights[i]));
      } else {
        double& of_other_stop = series.y[i % study.instants];
        of_other_stop = worse(of_other_stop, value(*flights[i]));
      }
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string table(const Study& study) {
  const bool bends = study.options.coupler_m.has_value();
  std::vector<page::Column> columns{{"fails at, s", true},   {"canard", true},      {"stop, deg", true},
                                    {"side force, N", true}, {"attack, deg", true}, {"rolled, deg", true},
                                    {"roll, deg/s", true},   {"turned, deg", true}, {"apogee, m", true},
                                    {"moved, m", true}};
  if (bends) {
    columns.push_back({"bending, N m", true});
  }
  std::vector<std::vector<page::Cell>> rows;
  for (const Effect& one : study.effects) {
    rows.push_back({{fixed(one.from_s, 2)},
                    {fmt::format("{}", one.canard + 1)},
                    {one.stop_rad == 0.0 ? "-" : text::brief(degrees(one.stop_rad), 1)},
                    {fixed(one.side_force_n, 2)},
                    {one.angle_of_attack_rad ? fixed(degrees(*one.angle_of_attack_rad), 1) : "-"},
                    {fixed(degrees(one.rolled_rad), 0)},
                    {fixed(degrees(one.roll_rate_rad_s), 0)},
                    {fixed(degrees(one.turned_rad), 1)},
                    {fixed(one.apogee_m, 0)},
                    {fixed(one.away_m, 1)}});
    if (bends) {
      rows.back().push_back({fixed(*one.moment_n_m, 2)});
    }
  }
  return page::table(columns, rows);
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

std::string study_text(const Study& study) {
  std::string text = headline(study) + "\n" + base(study) + "\n";
  for (const std::string& remark : remarks(study)) {
    text += "  " + remark + "\n";
  }
  for (const page::Page::Fact& fact : facts(study)) {
    text += fact.value.empty() ? "" : fmt::format("  {:<8} {}\n", fact.label, fact.value);
  }
  return text;
}

std::string study_json(const Study& study) {
  json::Value effects = json::Value::array();
  for (const Effect& one : study.effects) {
    effects.push_back(json(one));
  }
  const Effect worst = study.worst();
  const json::Value all = {
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
  return all.pretty();
}

std::string study_html(const Study& study) {
  const std::array<std::string, 2> first{
      page::figure(chart(study, "side force / N", [](const Effect& e) { return e.side_force_n; })),
      page::figure(chart(study, "way turned / deg", [](const Effect& e) { return degrees(e.turned_rad); }))};
  const std::array<std::string, 2> second{
      page::figure(chart(study, "apogee moved over ground / m", [](const Effect& e) { return e.away_m; })),
      page::figure(chart(study, "apogee / m", [](const Effect& e) { return e.apogee_m; }, smaller))};
  const std::array<std::string, 2> third{
      page::figure(chart(study, "angle of attack / deg",
                         [](const Effect& e) { return in_degrees(e.angle_of_attack_rad).value_or(std::nan("")); })),
      page::figure(chart(study, "rolled away / deg", [](const Effect& e) { return degrees(e.rolled_rad); }))};
  return page::html(
      {.kind = "Fantail: one canard that fails",
       .title = study.scenario,
       .subtitle = study.vehicle,
       .facts = facts(study),
       .verdict_heading = fmt::format("At worst of {} flights", study.effects.size()),
       .verdict = headline(study) + " " + base(study),
       .body_html = page::section("When it fails",
                                  page::side_by_side(first) + page::side_by_side(second) + page::side_by_side(third)) +
                    page::section("How this is known", page::list(remarks(study))) +
                    page::section("Every flight", table(study))});
}

}  // namespace fantail::hardover
