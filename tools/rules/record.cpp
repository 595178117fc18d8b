// SPDX-License-Identifier: MIT
#include "rules/record.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "rules/departure.hpp"
#include "rules/expression.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

/// Times of rows are sums of steps.
constexpr double rounding_s = 1e-6;

bool is_hole(double from_s, double to_s) { return to_s - from_s > longest_step_s + rounding_s; }

/// The true one, or where the avionics noticed it.
std::optional<double> apogee_s(const flight::Flight& flight) {
  const auto noticed = std::ranges::find_if(flight.phase_changes, [](const flight::PhaseChange& change) {
    return change.phase == core::Phase::finished && change.reason == core::PhaseReason::apogee;
  });
  const bool is_noticed = !flight.events.apogee_s && noticed != flight.phase_changes.end();
  return is_noticed ? std::optional{noticed->time_s} : flight.events.apogee_s;
}

std::optional<double> greatest_height_s(const std::vector<flight::Row>& rows) {
  std::optional<double> time_s;
  double greatest_m = -infinity;
  for (const flight::Row& row : rows) {
    if (row.time_s >= 0.0 && height_m(row) > greatest_m) {
      greatest_m = height_m(row);
      time_s = row.time_s;
    }
  }
  return time_s && rows.back().time_s > *time_s ? time_s : std::nullopt;
}

std::string seconds_text(double time_s) { return text::fixed(time_s, 2); }

ControlInLog unseen(std::string_view what, const std::vector<Hole>& hidden, std::optional<double> before_s) {
  const std::string missing = missing_text(hidden);
  const std::string said = fmt::format("does not show {} control began", what);
  return {.before_s = before_s,
          .why_unknown = missing.empty() ? "the record " + said : missing + ", so it " + said,
          .of_subject = ", which " + said};
}

/// Control that a gate ended again leaves dormant rows behind.
std::optional<double> first_chance_s(const std::vector<flight::Row>& rows, double start_s) {
  for (const Hole& hole : holes(rows, 0.0, start_s)) {
    const auto after = std::ranges::lower_bound(rows, hole.to_s, {}, &flight::Row::time_s);
    if (after != rows.end() && after->phase == core::Phase::dormant) {
      return hole.from_s;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Hole> holes(std::span<const flight::Row> rows, double from_s, double to_s) {
  std::vector<Hole> found;
  double seen_s = from_s;
  for (const flight::Row& row : rows) {
    if (seen_s >= to_s) {
      break;
    }
    if (row.time_s > from_s && is_hole(seen_s, row.time_s)) {
      found.push_back({std::max(seen_s, from_s), row.time_s});
    }
    seen_s = row.time_s;
  }
  if (is_hole(seen_s, to_s)) {
    found.push_back({std::max(seen_s, from_s), infinity});
  }
  return found;
}

std::string missing_text(const std::vector<Hole>& holes) {
  constexpr std::size_t most = 2;
  std::string all;
  for (const auto& [from_s, to_s] : std::span{holes}.first(std::min(most, holes.size()))) {
    const bool ends = to_s == infinity;
    const std::string_view verb = ends ? "ends at " : all.empty() ? "misses " : "";
    all += all.empty() ? "the record " : " and ";
    all += fmt::format("{}{}{} s", verb, seconds_text(from_s), ends ? "" : " to " + seconds_text(to_s));
  }
  return holes.size() > most ? all + " and more" : all;
}

std::optional<double> end_of_ascent(const flight::Flight& flight) {
  const auto known_s = apogee_s(flight);
  return known_s ? known_s : greatest_height_s(flight.rows);
}

std::string differing_text(const flight::Flight& log) {
  return log.differing_ticks == 0
             ? ""
             : text::counted(log.differing_ticks, "tick") + " of the record " +
                   (log.differing_ticks == 1 ? "differs from its replay" : "differ from their replay");
}

std::vector<Hole> holes_of_ascent(const flight::Flight& log) {
  const std::optional<double> end_s = end_of_ascent(log);
  // The greatest height on record may be that before the hole.
  const double beyond_s = apogee_s(log) ? 0.0 : 2.0 * longest_step_s;
  return holes(log.rows, 0.0, end_s ? *end_s + beyond_s : infinity);
}

ControlInLog control_in_log(const flight::Flight& log) {
  if (!log.known.phase) {
    return unseen("when", {}, {});
  }
  const auto& rows = log.rows;
  if (const auto& start_s = log.events.control_start_s) {
    const auto row = std::ranges::lower_bound(rows, *start_s, {}, &flight::Row::time_s);
    const bool is_seen = row != rows.end() && row != rows.begin() && !is_hole(*start_s, row->time_s) &&
                         !is_hole(std::prev(row)->time_s, row->time_s);
    if (is_seen) {
      return {.start_s = start_s, .first_s = first_chance_s(rows, *start_s), .before_s = start_s};
    }
    return unseen("when", holes(rows, 0.0, row == rows.end() ? infinity : row->time_s), start_s);
  }
  const auto controls = std::ranges::find(rows, core::Phase::controlling, &flight::Row::phase);
  if (controls != rows.end()) {
    return unseen("when", holes(rows, 0.0, controls->time_s), controls->time_s);
  }
  const std::vector<Hole> hidden = holes_of_ascent(log);
  const bool has_launch = log.events.liftoff_s || log.events.detected_s;
  if (!has_launch || !hidden.empty()) {
    return unseen("whether", has_launch ? hidden : std::vector<Hole>{}, infinity);
  }
  return {.before_s = infinity,
          .never_began = true,
          .why_unknown = "control never began",
          .of_subject = ", in which control never began"};
}

}  // namespace fantail::rules
