// SPDX-License-Identifier: MIT
#include "flight/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "flight/six_decimals.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::flight {
namespace {

struct TrajectoryColumn {
  const char* name;
  double PathPoint::* member;
  bool in_degrees = false;
};

constexpr std::array columns{TrajectoryColumn{"time_s", &PathPoint::time_s},
                             TrajectoryColumn{"north_m", &PathPoint::north_m},
                             TrajectoryColumn{"east_m", &PathPoint::east_m},
                             TrajectoryColumn{"height_m", &PathPoint::height_m},
                             TrajectoryColumn{"north_m_s", &PathPoint::north_m_s},
                             TrajectoryColumn{"east_m_s", &PathPoint::east_m_s},
                             TrajectoryColumn{"up_m_s", &PathPoint::up_m_s},
                             TrajectoryColumn{"tilt_deg", &PathPoint::tilt_rad, true},
                             TrajectoryColumn{"angle_of_attack_deg", &PathPoint::angle_of_attack_rad, true}};

}  // namespace

std::string trajectory_csv(const std::vector<PathPoint>& path) {
  std::string out;
  for (const TrajectoryColumn& column : columns) {
    out.append(out.empty() ? "" : ",").append(column.name);
  }
  out.push_back('\n');
  for (const PathPoint& point : path) {
    for (const TrajectoryColumn& column : columns) {
      const double value = point.*column.member;
      const SixDecimals decimals{column.in_degrees ? text::degrees(value) : value};
      out += decimals.text();
      out.push_back(&column == &columns.back() ? '\n' : ',');
    }
  }
  return out;
}

std::vector<PathPoint> read_trajectory(const Table& table) {
  std::vector<PathPoint> path(table.rows());
  for (const TrajectoryColumn& column : columns) {
    const std::size_t place = table.column(column.name);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto value = table.number(row, place);
      if (!value) {
        throw text::Error{text::ErrorKind::bad_data, table.where(row) + ": " + column.name + " = " +
                                                         in_quotes(table.cell(row, place)) + " is not a number"};
      }
      path[row].*column.member = column.in_degrees ? text::radians(*value) : *value;
    }
  }
  for (std::size_t row = 1; row < path.size(); ++row) {
    if (path[row].time_s <= path[row - 1].time_s) {
      throw text::Error{text::ErrorKind::bad_data, table.where(row) + ": time_s must increase"};
    }
  }
  return path;
}

double distance_m(const PathPoint& point) { return std::hypot(point.north_m, point.east_m); }

const PathPoint* point_at(const std::vector<PathPoint>& path, double time_s) {
  constexpr double clock_tolerance_s = 1e-6;
  const auto after = std::ranges::upper_bound(path, time_s + clock_tolerance_s, {}, &PathPoint::time_s);
  return after == path.begin() ? nullptr : &*(after - 1);
}

}  // namespace fantail::flight
