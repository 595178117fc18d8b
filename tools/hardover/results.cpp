// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "hardover/study.hpp"
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

/// The worst of all canards and instants.
std::string headline(const Study& study) {
  const Effect worst = study.worst();
  return fmt::format(
      "One canard {} turns this rocket's way by up to {} deg and moves its apogee by up to {} m. It rolls the rocket "
      "away by up to {} deg and pushes it aside by up to {} N.",
      what_fails(study), fixed(degrees(worst.turned_rad), 1), fixed(worst.away_m, 0),
      fixed(degrees(worst.rolled_rad), 0), fixed(worst.side_force_n, 1));
}

/// What else there is of the worst, for the terminal; the page has it in figures.
std::string further(const Study& study) {
  const Effect worst = study.worst();
  const std::string moment =
      worst.moment_n_m
          ? fmt::format("; bending at {} m {} N m", fixed(*study.options.coupler_m, 2), fixed(*worst.moment_n_m, 2))
          : "";
  return fmt::format("At worst: roll {} deg/s{}; lowest apogee {} m, and the sound rocket reaches {} m.",
                     fixed(degrees(worst.roll_rate_rad_s), 0), moment, fixed(worst.apogee_m, 0),
                     fixed(study.sound_apogee_m, 0));
}

std::string figures(const Study& study) {
  const Effect worst = study.worst();
  std::vector<page::Figure> list{
      {"way turned", fixed(degrees(worst.turned_rad), 1), "deg", "at most"},
      {"apogee moved", fixed(worst.away_m, 0), "m", "at most, over ground"},
      {"lowest apogee", fixed(worst.apogee_m, 0), "m",
       fmt::format("sound rocket: {} m", fixed(study.sound_apogee_m, 0))},
      {"rolled away", fixed(degrees(worst.rolled_rad), 0), "deg", "at most"},
      {"roll rate", fixed(degrees(worst.roll_rate_rad_s), 0), "deg/s",
       fmt::format("at most; sound rocket: {}", fixed(degrees(study.sound_roll_rate_rad_s), 0))},
      {"side force", fixed(worst.side_force_n, 1), "N", "at most, of the canards"}};
  if (worst.moment_n_m) {
    list.push_back({"bending moment", fixed(*worst.moment_n_m, 2), "N m",
                    fmt::format("at most, {} m from the tip", fixed(*study.options.coupler_m, 2))});
  }
  return page::figure_row(list);
}

/// What the rows are not.
std::string_view no_clearance() {
  return "Distances count from the sound rocket's apogee and not from the launch guide; the launch guide and the wind "
         "are those of the scenario, and others can give more. These rows clear no range by themselves: they have no "
         "point of impact and no flight without a parachute.";
}

std::vector<std::string> definitions() {
  return {"Sound rocket: the same flight without the failure; the two are compared until apogee.",
          fmt::format("Way turned: the largest angle between its velocity and the sound rocket's, above {} m/s.",
                      fixed(slowest_m_s, 0)),
          "Rolled away: the largest difference of its roll angle from the sound rocket's.",
          "Moved: how far its apogee is from the sound rocket's over ground, to whichever side."};
}

/// From how much the worst was taken.
std::string base(const Study& study) {
  constexpr std::size_t few = 20;
  return fmt::format(
      "The worst of {} flights: each of four canards{} at {}, every {} s from the end of the guide, {} s "
      "after ignition, to apogee at {} s.{}",
      study.effects.size(), study.options.failure == Failure::hard_over ? ", each stop," : "",
      study.instants == 1 ? "one instant" : fmt::format("{} instants", study.instants), fixed(study.options.step_s, 2),
      fixed(study.first_s, 2), fixed(study.last_s, 2),
      study.instants < few ? " With so few instants what lies between them can be worse (--step)." : "");
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

/// With its sign: which stop it is.
std::string stop_text(double stop_rad) {
  return fmt::format("{}{}", stop_rad > 0.0 ? "+" : "", text::brief(degrees(stop_rad), 1));
}

double larger(double a, double b) { return std::fmax(a, b); }  // of a figure that is not known the other
double smaller(double a, double b) { return std::min(a, b); }

/// Of each stop, by the canard that does worst.
page::Chart chart(const Study& study, const std::string& label, double (*value)(const Effect&),
                  double (*worse)(double, double) = larger) {
  page::Chart chart{
      .label = label, .x_label = "canard fails, s after ignition", .y_label = label, .width = page::half_page};
  for (const Effect& one : study.effects) {
    const bool is_other_stop = one.stop_rad < 0.0;
    const std::size_t curve = is_other_stop ? 1 : 0;
    if (chart.series.size() <= curve) {
      chart.series.push_back({.name = one.stop_rad == 0.0 ? "" : "stop at " + stop_text(one.stop_rad) + " deg",
                              .role = is_other_stop ? page::Role::model : page::Role::measured});
    }
    page::Series& series = chart.series[curve];
    if (one.canard == 0) {
      series.x.push_back(one.from_s);
      series.y.push_back(value(one));
    } else {
      double& worst =
          series.y[static_cast<std::size_t>(std::ranges::lower_bound(series.x, one.from_s) - series.x.begin())];
      worst = worse(worst, value(one));
    }
  }
  return chart;
}

/// What a curve is.
std::string curves(const Study& study) {
  return study.options.failure == Failure::hard_over
             ? "A curve is a stop, and at each instant the worst of the four canards. A canard at its positive stop "
               "rolls the rocket the positive way."
             : "At each instant the worst of the four canards.";
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
                    {one.stop_rad == 0.0 ? "-" : stop_text(one.stop_rad)},
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

}  // namespace

std::string study_text(const Study& study) {
  std::string text = fmt::format("{}\n{}\n{}\n  {}\n", headline(study), further(study), base(study), no_clearance());
  for (const std::string& remark : remarks(study)) {
    text += "  " + remark + "\n";
  }
  for (const page::Page::Fact& fact : facts(study)) {
    text += fact.value.empty() ? "" : fmt::format("  {:<8} {}\n", fact.label, fact.value);
  }
  return text;
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
                         [](const Effect& e) { return degrees(e.angle_of_attack_rad.value_or(std::nan(""))); })),
      page::figure(chart(study, "rolled away / deg", [](const Effect& e) { return degrees(e.rolled_rad); }))};
  return page::html(
      {.kind = "Fantail: one canard that fails",
       .title = study.scenario,
       .subtitle = study.vehicle,
       .facts = facts(study),
       .verdict_heading = fmt::format("At worst of {} flights", study.effects.size()),
       .verdict = headline(study),
       .findings = {{.about = std::string{no_clearance()}}},
       .body_html = page::section("At worst, each figure by itself", figures(study)) +
                    page::section("What the words mean", page::list(definitions())) +
                    page::section("When it fails", page::paragraph(curves(study)) + page::side_by_side(first) +
                                                       page::side_by_side(second) + page::side_by_side(third)) +
                    page::section("How this is known", page::paragraph(base(study)) + page::list(remarks(study))) +
                    page::section("Every flight", table(study))});
}

}  // namespace fantail::hardover
