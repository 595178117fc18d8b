// SPDX-License-Identifier: MIT
#include "report/html.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "flight/phase_names.hpp"
#include "page/page.hpp"
#include "report/rest.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using text::fixed;
using Rows = std::vector<std::vector<page::Cell>>;

/// So that the events of control are farther apart than its rows.
bool rows_are_sparse(const flight::Flight& flight, const Figures& f) {
  const flight::Events& e = flight.events;
  return f.control_time_s && e.control_start_s && e.control_end_s &&
         *e.control_end_s - *e.control_start_s - *f.control_time_s > 0.005;
}

std::string figure_list(const flight::Flight& flight, const Figures& f, bool roll_is_judged) {
  std::vector<page::Figure> list;
  const auto add = [&list](std::string label, const std::optional<double>& value, int decimals, std::string unit,
                           std::string remark = {}) {
    if (value) {
      list.push_back({std::move(label), fixed(*value, decimals), std::move(unit), std::move(remark)});
    }
  };
  add("Apogee", f.apogee_m, 1, "m");
  add(std::string{top_speed_name(flight)}, f.max_speed_m_s, 1, "m/s");
  if (const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value_or(-1.0))) {
    add("Drift at apogee", flight::distance_m(*top), 1, "m",
        flight.path_frame == flight::PathFrame::plane ? "over ground" : "over ground, towards " + compass(*top));
    add("Tilt at apogee", text::degrees(top->tilt_rad), 0, "deg");
  }
  add("Control starts", flight.events.control_start_s, 3, "s",
      f.control_start_height_m ? "at " + fixed(*f.control_start_height_m, 2) + " m" : "");
  add("Time under control", f.control_time_s, 2, "s",
      rows_are_sparse(flight, f) ? "from its first row to its last" : "");
  add("Largest hold error", roll_is_judged ? text::in_degrees(f.largest_hold_error_rad) : std::nullopt, 1, "deg",
      f.mean_hold_error_rad ? "mean " + fixed(text::degrees(*f.mean_hold_error_rad), 2) + " deg" : "");
  if (roll_is_judged && f.rest_error_rad) {
    add("Rests from its command", text::degrees(*f.rest_error_rad), 1, "deg",
        fmt::format("limit {} deg; mean |phi - R| under control {} deg",
                    text::brief(text::degrees(flight.rest_limit_rad), 1),
                    fixed(text::degrees(*f.mean_reference_error_rad), 1)));
  }
  add("Saturated",
      f.saturated_fraction && *f.control_time_s > 0.0 ? std::optional{100.0 * *f.saturated_fraction} : std::nullopt, 1,
      "%", "of control time");
  add("Turned after control", ended_early(flight, f) ? text::in_degrees(f.roll_after_end_rad) : std::nullopt, 1, "deg",
      f.ended_before_apogee_s ? "until apogee" : "until the trajectory ends");
  add("Largest fin offset", text::in_degrees(f.largest_disturbance_rad), 1, "deg", "true u_d under control");
  add("Authority margin", text::in_degrees(f.authority_margin_rad), 1, "deg",
      f.authority_rad ? "of " + text::brief(text::degrees(*f.authority_rad), 1) + " deg" : "");
  if (f.side_deflection) {
    const auto& moment_n_m = f.side_deflection->largest_moment_n_m;
    add("Side deflection", text::degrees(f.side_deflection->largest_rad), 1, "deg",
        fmt::format("mean {} deg{}", fixed(text::degrees(f.side_deflection->mean_rad), 2),
                    moment_n_m ? fmt::format("; at most {} N m", fixed(*moment_n_m, 3)) : ""));
  }
  for (const flight::LoopMargin& margin : different_margins(flight)) {
    list.push_back({"Phase margin", fixed(text::degrees(margin.phase_margin_rad), 0), "deg",
                    fmt::format("at {} m/s; gain margin {}", fixed(margin.speed_m_s, 0), gain_margin_text(margin))});
  }
  if (f.camera_roll) {
    add("Camera's roll", text::degrees(f.camera_roll->largest_rad), 1, "deg",
        fmt::format("at most from the roll angle; {} deg at the end",
                    fixed(text::degrees(f.camera_roll->at_end_rad), 1)));
  }
  add("Net roll", f.roll_turns, 2, "turns", "under control");
  add("Net roll without control", f.roll_turns_without_control, 2, "turns", "canards at trim");
  if (flight.gyro_bias_rad_s) {
    add("Gyro zero", text::degrees(static_cast<double>(flight.gyro_bias_rad_s->x)), 2, "deg/s",
        "about the long axis; taken off");
  }
  if (flight.known.phase) {
    list.push_back({"Final phase", flight::display_name(f.final_phase), "", ""});
  }
  std::string html = page::figure_row(list);
  if (roll_is_judged && f.largest_hold_error_rad) {
    html += page::note(settle_point_text(flight), "settles");
  }
  return html;
}

std::vector<page::Cell> row(double time_s, std::string_view what, std::string_view meaning) {
  return {{fixed(time_s, 3)}, {std::string{what}}, {std::string{meaning}}};
}

std::string table(std::string what, std::string meaning, const Rows& rows) {
  const std::array<page::Column, 3> columns{{{"Time / s", true}, {std::move(what)}, {std::move(meaning)}}};
  return page::table(columns, rows);
}

std::string event_table(const flight::Flight& flight) {
  std::vector<double> times_s;
  Rows rows;  // by time; of two at the same instant the one added first
  const auto add = [&](const std::optional<double>& time_s, std::string_view event, std::string_view meaning) {
    if (time_s) {
      const auto place = std::ranges::upper_bound(times_s, *time_s);
      rows.insert(rows.begin() + (place - times_s.begin()), row(*time_s, event, meaning));
      times_s.insert(place, *time_s);
    }
  };
  const flight::Events& e = flight.events;
  add(e.liftoff_s, "Lift-off",
      flight.seed ? "first net upward acceleration" : "where the specific force left the pad's 1 g");
  add(e.detected_s, "Launch detected", "roll angle is zero here");
  add(e.guide_clear_s, "Off the guide", "true time, not known on board");
  add(e.control_start_s, "Control starts",
      flight.tunnel ? "roll angle is zero here, canards leave trim" : "canards leave trim");
  add(e.burnout_s, "Burn-out", "");
  add(e.apogee_s, "Apogee", "");
  add(e.parachute_s, "Parachute", "begins to open; true time, not known on board");
  if (const auto jolt = jolt_after_apogee(flight)) {
    add(jolt->time_s, "Jolt",
        fmt::format("{} g along the axis, as when a parachute opens",
                    text::fixed(jolt->specific_force_m_s2 / 9.80665, 1)));
  }
  const auto ended_it = std::ranges::find(flight.outages, e.control_end_s, &flight::Outage::from_s);
  add(e.control_end_s, "Control ends",
      ended_it == flight.outages.end() ? "canards return to trim"
      : ended_it->to_s                 ? fmt::format("with the last tick before {} s", fixed(*ended_it->to_s, 3))
                                       : "with the last tick");
  if (rows.empty()) {
    return page::paragraph(flight.known.phase ? "No events." : "Not in the log.");
  }
  return table("Event", "", rows);
}

std::string phase_table(const flight::Flight& flight) {
  if (!flight.known.phase || flight.phase_changes.empty()) {
    return page::paragraph(flight.known.phase ? "Safe throughout." : "Not in the log.");
  }
  Rows rows;
  for (const flight::PhaseChange& change : flight.phase_changes) {
    const bool is_first = !flight.rows.empty() && change.time_s <= flight.rows.front().time_s;
    rows.push_back(
        row(change.time_s, flight::display_name(change.phase), flight::why_it_began(change.reason, is_first)));
  }
  return table("Phase", "Reason", rows);
}

std::string canard_table(const flight::Flight& flight) {
  Rows rows;
  for (const flight::CanardVerdictChange& change : flight.canard_verdict_changes) {
    rows.push_back(row(change.time_s, std::to_string(change.canard + 1), core::name(change.verdict)));
  }
  return rows.empty() ? "" : table("Canard", "Monitor verdict", rows);
}

std::string about_section(const flight::Flight& flight) {
  std::vector<std::string> all = flight.notes;
  if (const std::string imposed = flight::imposed_roll_sentence(flight); !imposed.empty()) {
    all.insert(all.begin(), "Imposed: " + imposed);
  }
  if (!flight.seed && flight.notes.empty()) {
    return {};
  }
  return page::section(flight.seed ? "Assumptions and notes" : "About the log",
                       all.empty()
                           ? page::paragraph("The scenario has no imposed roll, no faults and no further assumptions.")
                           : page::list(all));
}

}  // namespace

page::Tone tone(const Verdict& verdict) {
  // Steady, though not where it was commanded to be.
  return verdict.outcome == Outcome::off_command ? page::Tone::unsure : result::tone(answer(verdict));
}

std::string html(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  page::Page page{.kind = "Fantail flight report",
                  .title = flight.scenario,
                  .facts = {{"Vehicle", flight.vehicle},
                            {"Plan", flight.plan_name},
                            {"Seed", flight.seed ? std::to_string(*flight.seed) : ""},
                            {"Fantail", flight.version}},
                  .tone = tone(verdict),
                  .verdict_heading = std::string{display_name(verdict.outcome)},
                  .verdict = verdict.text,
                  .footer =
                      "Every tick is in flight.csv, every figure in summary.json, beside this page. The plots "
                      "leave out most samples but no peak. Plots drawn with uPlot (MIT licence, in the source of "
                      "this page).",
                  .command = flight.command,
                  .live = charts(flight)};
  if (verdict.roll_is_judged && figures.largest_hold_error_rad && flight.why_uncontrollable.empty()) {
    page.findings.push_back({"", fmt::format("It settles at {}.", settle_point_name(flight)), "settles"});
  }
  if (figures.roll_turns && figures.roll_turns_without_control) {
    page.findings.push_back(
        {"", fmt::format("Under control it turned by {} turns; with its canards at trim it would have turned by {}.",
                         fixed(*figures.roll_turns, 2), fixed(*figures.roll_turns_without_control, 2))});
  }
  if (figures.camera_roll && std::abs(figures.camera_roll->largest_rad) >= text::radians(1.0)) {
    page.findings.push_back(
        {"", fmt::format("The rocket coned: what a camera sees of its roll came up to {} deg away from the roll angle, "
                         "which is the integral of the gyro's rate.",
                         fixed(std::abs(text::degrees(figures.camera_roll->largest_rad)), 1))});
  }
  if (!flight.changes.empty()) {
    page.findings.push_back({"", fmt::format("Changed on the command line: {}.", fmt::join(flight.changes, ", "))});
  }
  if (const std::string imposed = flight::imposed_roll_sentence(flight); !imposed.empty()) {
    page.findings.push_back({"", imposed});
  }
  const std::array<std::string, 2> columns{page::section("Events", event_table(flight)),
                                           page::section("Phases", phase_table(flight) + canard_table(flight))};
  page.body_html = page::section("The flight", page::live_figure(page.live, "Roll angle over time")) +
                   page::section("Figures", figure_list(flight, figures, verdict.roll_is_judged)) +
                   path_section(flight) + turning_section(flight) + page::side_by_side(columns) + about_section(flight);
  return page::html(page);
}

}  // namespace fantail::report
