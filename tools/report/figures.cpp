// SPDX-License-Identifier: MIT
#include "report/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "report/running_figures.hpp"

namespace fantail::report {
namespace {

/// Without a pause each: between two of them the gate had closed again.
std::vector<std::span<const flight::Row>> spells_of_control(const flight::Flight& flight) {
  const auto is_control = [](const flight::Row& row) { return row.phase == core::Phase::controlling; };
  std::vector<std::span<const flight::Row>> all;
  auto begin = std::ranges::find_if(flight.rows, is_control);
  while (begin != flight.rows.end() && is_control(*begin)) {
    const auto end = std::find_if_not(begin, flight.rows.end(), is_control);
    all.emplace_back(begin, end);
    begin =
        std::find_if(end, flight.rows.end(), [](const flight::Row& row) { return row.phase != core::Phase::dormant; });
  }
  return all;
}

/// Net, of the free roll in the time of these; empty: not known.
std::optional<double> turns_without_control(const flight::Flight& flight,
                                            const std::vector<std::span<const flight::Row>>& spells) {
  double sum_rad = 0.0;
  for (const std::span<const flight::Row> spell : spells) {
    const auto begin_rad = flight::free_roll_angle_rad(flight.without_control, spell.front().time_s);
    const auto end_rad = flight::free_roll_angle_rad(flight.without_control, spell.back().time_s);
    if (!begin_rad || !end_rad) {
      return {};
    }
    sum_rad += *end_rad - *begin_rad;
  }
  return spells.empty() ? std::nullopt : std::optional{sum_rad / (2.0 * std::numbers::pi)};
}

}  // namespace

double true_zero_rad(const flight::Flight& flight) {
  TrueZero zero{flight.tunnel};
  for (const flight::Row& row : flight.rows) {
    zero.add(row);
  }
  return zero.rad();
}

std::string_view speed_kind(const flight::Flight& flight) {
  const bool is_true = flight.seed || std::ranges::any_of(flight.rows, [](const flight::Row& row) {
                         return row.truth && std::isfinite(row.truth->speed_m_s);
                       });
  return is_true ? "through the air" : "by the log";
}

std::string top_speed_name(const flight::Flight& flight) {
  if (flight.tunnel) {
    return "largest air speed";
  }
  return fmt::format("top speed {}", flight.path.empty() ? speed_kind(flight) : "over ground");
}

Figures figures(const flight::Flight& flight) {
  RunningFigures running{flight.tunnel};
  for (const flight::Row& row : flight.rows) {
    running.add(row, flight);
  }
  Figures f = running.figures(flight);
  const std::vector<std::span<const flight::Row>> spells = spells_of_control(flight);
  for (std::size_t i = f.misses_control_start ? 1 : 0; i < spells.size() && i <= f.reopenings.size(); ++i) {
    if (Capture& capture = i == 0 ? f.capture : f.reopenings[i - 1].capture; !capture.watched_s) {
      const std::optional<double> turn = capture.turn;
      capture = measured_capture(flight, spells[i]);
      capture.turn = turn;
    }
  }
  if (!spells.empty()) {
    f.side_deflection = side_deflection(flight, {spells.front().begin(), spells.back().end()});
  }
  f.roll_turns_without_control = turns_without_control(flight, spells);
  return f;
}

}  // namespace fantail::report
