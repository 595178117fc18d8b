// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flight/table.hpp"

namespace fantail::flight {

/// How the same rocket would have rolled with its canards at trim, as only a simulator can tell.
struct FreeRollPoint {
  double time_s = 0.0;               ///< on the rows' clock
  double true_roll_angle_rad = 0.0;  ///< since the pad, not wrapped, as Truth::roll_angle_rad
  double true_roll_rate_rad_s = 0.0;
};

/// without_control.csv: one row a point.
[[nodiscard]] std::string free_roll_csv(const std::vector<FreeRollPoint>& points);

/// The other way. Throws as read_points().
[[nodiscard]] std::vector<FreeRollPoint> read_free_roll(const Table& table);

/// Between two points on the line through them; empty before the first and after the last.
[[nodiscard]] std::optional<double> free_roll_angle_rad(const std::vector<FreeRollPoint>& points, double time_s);

}  // namespace fantail::flight
