// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "logs/read_csv.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

std::optional<core::Phase> phase_named(std::string_view word) {
  for (std::size_t i = 0; i < core::phases; ++i) {
    if (core::name(static_cast<core::Phase>(i)) == word) {
      return static_cast<core::Phase>(i);
    }
  }
  return {};
}

// Control comes once in a flight, and is over with it. Only a reset leads from control to Safe, and from there back.
std::optional<std::size_t> second_flight(const std::vector<flight::Row>& rows) {
  bool was_controlled = false;
  bool is_over = false;
  std::optional<std::size_t> anew;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const core::Phase phase = rows[i].phase;
    const bool is_control = phase == core::Phase::controlling;
    if (was_controlled && (phase == core::Phase::launched || (is_control && is_over))) {
      return anew.value_or(i);
    }
    if (is_control || phase == core::Phase::finished) {
      anew.reset();
    } else if (was_controlled && !anew) {
      anew = i;
    }
    was_controlled = was_controlled || is_control;
    is_over = is_over || (was_controlled && (phase == core::Phase::finished || phase == core::Phase::armed));
  }
  return {};
}

}  // namespace

void read_phases(const flight::Table& table, const files::Rows& rows, std::size_t column, flight::Flight& flight) {
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const std::string_view word = table.cell(rows.rows[i], column);
    const auto phase = phase_named(word);
    if (!phase) {
      flight.notes.push_back(fmt::format("{}: {} is not a flight phase; the column phase is ignored.",
                                         table.where(rows.rows[i]), flight::in_quotes(word)));
      std::ranges::for_each(flight.rows, [](flight::Row& row) { row.phase = flight::Row{}.phase; });
      return;
    }
    flight.rows[i].phase = *phase;
  }
  flight.known.phase = true;
}

void note_phases(flight::Flight& flight, const std::string& name) {
  if (!flight.known.phase) {
    return;
  }
  if (const auto anew = second_flight(flight.rows)) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: contains more than one flight: a new one begins at {:.3f} s, where the phase is {} after "
                    "control; put each flight into a separate table",
                    name, flight.rows[*anew].time_s, core::name(flight.rows[*anew].phase))};
  }
  // Why they changed stands in no table. Nor does when, where it was in a hole.
  const double usual_step_s =
      (flight.rows.back().time_s - flight.rows.front().time_s) / static_cast<double>(flight.rows.size());
  const double longest_step_s = std::max(0.1, 3.0 * usual_step_s);
  for (std::size_t i = 0; i < flight.rows.size(); ++i) {
    const auto [time_s, phase] = std::pair{flight.rows[i].time_s, flight.rows[i].phase};
    const core::Phase before = i == 0 ? core::Phase::safe : flight.rows[i - 1].phase;
    if (phase == before) {
      continue;
    }
    flight.phase_changes.push_back({time_s, phase, {}});
    if (i > 0 && time_s - flight.rows[i - 1].time_s <= longest_step_s) {  // one in the first row began before it
      flight::note_phase_event(flight.events, before, phase, time_s);
    }
  }
}

}  // namespace fantail::logs
