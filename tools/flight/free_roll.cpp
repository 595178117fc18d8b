// SPDX-License-Identifier: MIT
#include "flight/free_roll.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "flight/point_table.hpp"

namespace fantail::flight {
namespace {

using Column = PointColumn<FreeRollPoint>;

constexpr double between_points_s = 0.01;

constexpr std::array columns{Column{"time_s", &FreeRollPoint::time_s},
                             Column{"true_roll_angle_deg", &FreeRollPoint::true_roll_angle_rad, true},
                             Column{"true_roll_rate_deg_s", &FreeRollPoint::true_roll_rate_rad_s, true}};

}  // namespace

std::string free_roll_csv(const std::vector<FreeRollPoint>& points) {
  return write_points<FreeRollPoint>(points, columns);
}

std::vector<FreeRollPoint> read_free_roll(const Table& table) { return read_points<FreeRollPoint>(table, columns); }

std::optional<double> free_roll_angle_rad(const std::vector<FreeRollPoint>& points, double time_s) {
  const auto after = std::ranges::lower_bound(points, time_s, {}, &FreeRollPoint::time_s);
  if (after == points.end() && !points.empty() && time_s - points.back().time_s < between_points_s) {
    return points.back().true_roll_angle_rad;  // the next point would have come later than the last row
  }
  if (after == points.end() || (after == points.begin() && after->time_s != time_s)) {
    return std::nullopt;
  }
  if (after->time_s == time_s) {
    return after->true_roll_angle_rad;
  }
  const FreeRollPoint& before = *(after - 1);
  const double part = (time_s - before.time_s) / (after->time_s - before.time_s);
  return std::lerp(before.true_roll_angle_rad, after->true_roll_angle_rad, part);
}

}  // namespace fantail::flight
