// SPDX-License-Identifier: MIT
#include "flight/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "flight/point_table.hpp"

namespace fantail::flight {
namespace {

using Column = PointColumn<PathPoint>;

constexpr std::array by_compass{Column{"time_s", &PathPoint::time_s},
                                Column{"north_m", &PathPoint::north_m},
                                Column{"east_m", &PathPoint::east_m},
                                Column{"height_m", &PathPoint::height_m},
                                Column{"north_m_s", &PathPoint::north_m_s},
                                Column{"east_m_s", &PathPoint::east_m_s},
                                Column{"up_m_s", &PathPoint::up_m_s},
                                Column{"tilt_deg", &PathPoint::tilt_rad, true},
                                Column{"angle_of_attack_deg", &PathPoint::angle_of_attack_rad, true}};

constexpr const char* across = "across_m";
constexpr std::array in_plane{Column{"time_s", &PathPoint::time_s},     Column{across, &PathPoint::north_m},
                              Column{"height_m", &PathPoint::height_m}, Column{"across_m_s", &PathPoint::north_m_s},
                              Column{"up_m_s", &PathPoint::up_m_s},     Column{"tilt_deg", &PathPoint::tilt_rad, true}};

std::span<const Column> columns_of(PathFrame frame) {
  return frame == PathFrame::plane ? std::span<const Column>{in_plane} : by_compass;
}

}  // namespace

std::string trajectory_csv(const std::vector<PathPoint>& path, PathFrame frame) {
  return write_points(path, columns_of(frame));
}

std::vector<PathPoint> read_trajectory(const Table& table, PathFrame frame) {
  return read_points(table, columns_of(frame));
}

PathFrame path_frame(const Table& table) { return table.find(across) ? PathFrame::plane : PathFrame::compass; }

double distance_m(const PathPoint& point) { return std::hypot(point.north_m, point.east_m); }

const PathPoint* point_at(const std::vector<PathPoint>& path, double time_s) {
  constexpr double clock_tolerance_s = 1e-6;
  const auto after = std::ranges::upper_bound(path, time_s + clock_tolerance_s, {}, &PathPoint::time_s);
  return after == path.begin() ? nullptr : &*(after - 1);
}

}  // namespace fantail::flight
