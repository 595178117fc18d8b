// SPDX-License-Identifier: MIT
#include "report/figures.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <span>

#include "report/running_figures.hpp"

namespace fantail::report {
namespace {

/// With the times in which the gate had closed again.
std::span<const flight::Row> under_control(const flight::Flight& flight) {
  const auto is_control = [](const flight::Row& row) { return row.phase == core::Phase::controlling; };
  const auto first = std::ranges::find_if(flight.rows, is_control);
  const auto end = std::find_if(first, flight.rows.end(), [&](const flight::Row& row) {
    return !is_control(row) && row.phase != core::Phase::dormant;
  });
  const auto last = std::find_if(std::reverse_iterator{end}, std::reverse_iterator{first}, is_control);
  return {first, last.base()};
}

}  // namespace

double true_zero_rad(const flight::Flight& flight) {
  TrueZero zero{flight.tunnel};
  for (const flight::Row& row : flight.rows) {
    zero.add(row);
  }
  return zero.rad();
}

std::string_view top_speed_name(const flight::Flight& flight) {
  if (flight.tunnel) {
    return "largest air speed";
  }
  return flight.path.empty() ? "top speed" : "top speed over ground";
}

Figures figures(const flight::Flight& flight) {
  RunningFigures running{flight.tunnel};
  for (const flight::Row& row : flight.rows) {
    running.add(row, flight);
  }
  Figures f = running.figures(flight);
  if (f.control_time_s && !f.capture.watched_s) {
    const std::optional<double> turn = f.capture.turn;
    f.capture = measured_capture(flight);
    f.capture.turn = turn;
  }
  if (const auto control = under_control(flight); !control.empty()) {
    f.side_deflection = side_deflection(flight, control);
    const auto begin_rad = flight::free_roll_angle_rad(flight.without_control, control.front().time_s);
    const auto end_rad = flight::free_roll_angle_rad(flight.without_control, control.back().time_s);
    if (begin_rad && end_rad) {
      f.roll_turns_without_control = (*end_rad - *begin_rad) / (2.0 * std::numbers::pi);
    }
  }
  return f;
}

}  // namespace fantail::report
