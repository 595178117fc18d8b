// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "flight/flight.hpp"
#include "text/degrees.hpp"

namespace fantail::report {

/// Of a simulated flight: its pictures show how the rocket truly rolled. Of a log: how the flight computer knew it.
[[nodiscard]] inline bool knows_true_roll(std::span<const flight::Row> rows) {
  return std::ranges::any_of(rows, [](const flight::Row& row) { return row.truth.has_value(); });
}

/// Not a number where it is not known.
[[nodiscard]] inline double roll_deg(const flight::Row& row, bool is_true) {
  if (!is_true) {
    return text::degrees(row.roll_angle_rad);
  }
  return row.truth ? text::degrees(row.truth->roll_angle_rad) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fantail::report
