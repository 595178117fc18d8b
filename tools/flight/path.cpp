// SPDX-License-Identifier: MIT
#include "flight/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "flight/point_table.hpp"

namespace fantail::flight {
namespace {

constexpr std::array by_compass{PointColumn<PathPoint>{"time_s", &PathPoint::time_s},
                                PointColumn<PathPoint>{"north_m", &PathPoint::north_m},
                                PointColumn<PathPoint>{"east_m", &PathPoint::east_m},
                                PointColumn<PathPoint>{"height_m", &PathPoint::height_m},
                                PointColumn<PathPoint>{"north_m_s", &PathPoint::north_m_s},
                                PointColumn<PathPoint>{"east_m_s", &PathPoint::east_m_s},
                                PointColumn<PathPoint>{"up_m_s", &PathPoint::up_m_s},
                                PointColumn<PathPoint>{"tilt_deg", &PathPoint::tilt_rad, true},
                                PointColumn<PathPoint>{"angle_of_attack_deg", &PathPoint::angle_of_attack_rad, true}};

constexpr const char* across = "across_m";
constexpr std::array in_plane{PointColumn<PathPoint>{"time_s", &PathPoint::time_s},
                              PointColumn<PathPoint>{across, &PathPoint::north_m},
                              PointColumn<PathPoint>{"height_m", &PathPoint::height_m},
                              PointColumn<PathPoint>{"across_m_s", &PathPoint::north_m_s},
                              PointColumn<PathPoint>{"up_m_s", &PathPoint::up_m_s},
                              PointColumn<PathPoint>{"tilt_deg", &PathPoint::tilt_rad, true}};

std::span<const PointColumn<PathPoint>> columns_of(PathFrame frame) {
  return frame == PathFrame::plane ? std::span<const PointColumn<PathPoint>>{in_plane} : by_compass;
}

constexpr double between_points_s = 0.01;

constexpr std::array free_roll_columns{
    PointColumn<FreeRollPoint>{"time_s", &FreeRollPoint::time_s},
    PointColumn<FreeRollPoint>{"true_roll_angle_deg", &FreeRollPoint::true_roll_angle_rad, true},
    PointColumn<FreeRollPoint>{"true_roll_rate_deg_s", &FreeRollPoint::true_roll_rate_rad_s, true}};

constexpr std::array turning_columns{
    PointColumn<TurnPoint>{"time_s", &TurnPoint::time_s},
    PointColumn<TurnPoint>{"true_roll_rate_deg_s", &TurnPoint::true_roll_rate_rad_s, true},
    PointColumn<TurnPoint>{"true_pitch_rate_deg_s", &TurnPoint::true_pitch_rate_rad_s, true},
    PointColumn<TurnPoint>{"true_yaw_rate_deg_s", &TurnPoint::true_yaw_rate_rad_s, true},
    PointColumn<TurnPoint>{"true_tilt_deg", &TurnPoint::true_tilt_rad, true},
    PointColumn<TurnPoint>{"gyro_roll_rate_deg_s", &TurnPoint::gyro_roll_rate_rad_s, true},
    PointColumn<TurnPoint>{"gyro_pitch_rate_deg_s", &TurnPoint::gyro_pitch_rate_rad_s, true},
    PointColumn<TurnPoint>{"gyro_yaw_rate_deg_s", &TurnPoint::gyro_yaw_rate_rad_s, true},
    PointColumn<TurnPoint>{"tilt_deg", &TurnPoint::tilt_rad, true}};

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

std::string free_roll_csv(const std::vector<FreeRollPoint>& points) {
  return write_points<FreeRollPoint>(points, free_roll_columns);
}

std::vector<FreeRollPoint> read_free_roll(const Table& table) {
  return read_points<FreeRollPoint>(table, free_roll_columns);
}

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

std::string turning_csv(const std::vector<TurnPoint>& turning) {
  return write_points<TurnPoint>(turning, turning_columns);
}

std::vector<TurnPoint> read_turning(const Table& table) { return read_points<TurnPoint>(table, turning_columns); }

}  // namespace fantail::flight
