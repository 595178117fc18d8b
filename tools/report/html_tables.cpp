// SPDX-License-Identifier: MIT
#include "report/html_tables.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "report/escape.hpp"
#include "report/numbers.hpp"
#include "report/timeline.hpp"
#include "report/words.hpp"

namespace fantail::report {
namespace {

std::string figure(std::string_view label, const std::optional<double>& value, int decimals, std::string_view unit,
                   std::string_view note = "") {
  if (!value) {
    return {};
  }
  return fmt::format("<div><dt>{}</dt><dd>{}<span> {}</span>{}</dd></div>\n", label,
                     with_minus(fixed(*value, decimals)), unit,
                     note.empty() ? "" : fmt::format("<small>{}</small>", note));
}

std::optional<double> in_degrees(const std::optional<double>& radians) {
  return radians ? std::optional{degrees(*radians)} : std::nullopt;
}

std::string time_row(std::string_view event, const std::optional<double>& time_s, std::string_view meaning) {
  if (!time_s) {
    return {};
  }
  return fmt::format("<tr><td class=\"number\">{}</td><td>{}</td><td>{}</td></tr>\n", with_minus(fixed(*time_s, 3)),
                     event, meaning);
}

}  // namespace

std::string figure_list(const Flight& flight, const Figures& f) {
  const std::optional<double> saturated =
      f.saturated_fraction ? std::optional{100.0 * *f.saturated_fraction} : std::nullopt;
  const std::string limit =
      flight.known.plan ? "limit " + brief(degrees(canard_limit_rad(flight.plan)), 1) + " deg" : "";
  std::string list = "<dl class=\"figures\">\n";
  list += figure("Apogee", f.apogee_m, 1, "m");
  list += figure(flight.tunnel ? "Largest air speed" : "Top speed", f.max_speed_m_s, 1, "m/s");
  list += figure("Control starts", flight.events.control_start_s, 3, "s",
                 f.control_start_height_m ? "at " + fixed(*f.control_start_height_m, 2) + " m" : "");
  list += figure("Time under control", f.control_time_s, 2, "s");
  list += figure("Largest hold error", in_degrees(f.largest_hold_error_rad), 1, "deg",
                 f.mean_hold_error_rad ? "mean " + fixed(degrees(*f.mean_hold_error_rad), 2) + " deg" : "");
  list += figure("Saturated", saturated, 1, "%", "of control time");
  list += figure("Largest fin offset", in_degrees(f.largest_disturbance_rad), 1, "deg", "true u_d under control");
  list += figure("Authority margin", in_degrees(f.authority_margin_rad), 1, "deg", limit);
  list += figure("Net roll", f.roll_turns, 2, "turns", "under control");
  if (flight.known.phase) {
    list += fmt::format("<div><dt>Final phase</dt><dd>{}</dd></div>\n", words(f.final_phase));
  }
  list += "</dl>\n";
  if (f.largest_hold_error_rad) {
    list += fmt::format(
        "<p class=\"aside\">A proportional-derivative loop comes to rest at R&nbsp;+&nbsp;u_d/kp, not at the reference "
        "R: an angle error has to balance the fin offset. The hold error is measured from there, without the {} "
        "after control start and after each reference step.</p>\n",
        flight.tunnel ? "two seconds" : "second");
  }
  return list;
}

std::string phase_legend(const Flight& flight) {
  if (!flight.known.phase) {
    return {};
  }
  std::string legend = "<p class=\"phases\">Phases:";
  std::array<bool, 5> named{};
  const double begin_s = plot_window(flight).begin_s;
  for (const PhaseBand& band : phase_bands(flight)) {
    if (band.end_s > begin_s && !named[static_cast<std::size_t>(band.phase)]) {
      named[static_cast<std::size_t>(band.phase)] = true;
      legend += fmt::format(" <span><i class=\"{}\"></i>{}</span>", core::name(band.phase), words(band.phase));
    }
  }
  return legend + "</p>\n";
}

std::string event_table(const Flight& flight) {
  struct TableRow {
    double time_s;
    std::string html;
  };
  std::vector<TableRow> rows;  // by time; of two at the same instant the one added first
  const auto add = [&rows](const std::optional<double>& time_s, std::string_view event, std::string_view meaning) {
    if (time_s) {
      const auto place = std::ranges::upper_bound(rows, *time_s, {}, &TableRow::time_s);
      rows.insert(place, {*time_s, time_row(event, time_s, meaning)});
    }
  };
  const Events& e = flight.events;
  add(e.liftoff_s, "Lift-off",
      flight.seed ? "first net upward acceleration" : "where the specific force left the pad's 1 g");
  add(e.detected_s, "Launch detected", "roll angle is zero here");
  add(e.guide_clear_s, "Off the guide", "truth, not known on board");
  add(e.control_start_s, "Control starts",
      flight.tunnel ? "roll angle is zero here, canards leave trim" : "canards leave trim");
  add(e.burnout_s, "Burn-out", "");
  add(e.apogee_s, "Apogee", "");
  add(e.control_end_s, "Control ends", "canards return to trim");
  if (rows.empty()) {
    return flight.known.phase ? "<p>Nothing happened.</p>\n" : "<p>The log does not tell.</p>\n";
  }
  std::string table =
      "<table><thead><tr><th class=\"number\">Time, s</th><th>Event</th><th></th></tr></thead><tbody>\n";
  for (const TableRow& row : rows) {
    table += row.html;
  }
  return table + "</tbody></table>\n";
}

std::string phase_table(const Flight& flight) {
  if (!flight.known.phase) {
    return "<p>The log does not tell.</p>\n";
  }
  if (flight.phase_changes.empty()) {
    return "<p>Safe throughout.</p>\n";
  }
  std::string table =
      "<table><thead><tr><th class=\"number\">Time, s</th><th>Phase</th><th>Because</th></tr></thead><tbody>\n";
  for (const PhaseChange& change : flight.phase_changes) {
    table += time_row(words(change.phase), change.time_s, change.reason ? words(*change.reason) : "");
  }
  return table + "</tbody></table>\n";
}

std::string canard_table(const Flight& flight) {
  if (flight.canard_verdict_changes.empty()) {
    return {};
  }
  std::string table =
      "<table><thead><tr><th class=\"number\">Time, s</th><th>Canard</th><th>Monitor says</th></tr></thead><tbody>\n";
  for (const CanardVerdictChange& change : flight.canard_verdict_changes) {
    table += time_row(std::to_string(change.canard + 1), change.time_s, core::name(change.verdict));
  }
  return table + "</tbody></table>\n";
}

std::string assumption_list(const Flight& flight) {
  std::string list;
  if (const std::string imposed = imposed_roll_words(flight); !imposed.empty()) {
    list += "<li><b>Imposed:</b> " + with_minus(escape_html(imposed)) + "</li>\n";
  }
  for (const std::string& note : flight.notes) {
    list += "<li>" + escape_html(note) + "</li>\n";
  }
  return list.empty() ? "<p>The scenario names no imposed roll, no faults and no assumptions of its own.</p>\n"
                      : "<ul>\n" + list + "</ul>\n";
}

}  // namespace fantail::report
