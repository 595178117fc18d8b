// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flight/table.hpp"

namespace fantail::flight {

/// What the places of a path are counted by.
enum class PathFrame : std::uint8_t {
  compass,  ///< north and east
  plane     ///< across in one vertical plane, which points nobody knows where
};

/// Where a rocket truly was that moves in six degrees of freedom, or as another program has simulated it. In a plane
/// north is across, and east and the angle of attack are not known and zero.
struct PathPoint {
  double time_s = 0.0;  ///< on the rows' clock
  double north_m = 0.0;
  double east_m = 0.0;  ///< both from the foot of the guide
  double height_m = 0.0;
  double north_m_s = 0.0;  ///< over ground, as the next two
  double east_m_s = 0.0;
  double up_m_s = 0.0;
  double tilt_rad = 0.0;             ///< of the long axis, from the vertical
  double tilt_from_guide_rad = 0.0;  ///< of the long axis, from where it pointed at rest; no file has it
  double angle_of_attack_rad = 0.0;  ///< between the long axis and the way through the air
};

/// trajectory.csv: one row a point, what is known of it.
[[nodiscard]] std::string trajectory_csv(const std::vector<PathPoint>& path, PathFrame frame);

/// The other way. Throws text::Error (bad_data) for a missing column, a cell without a number, time that does not
/// increase.
[[nodiscard]] std::vector<PathPoint> read_trajectory(const Table& table, PathFrame frame);

/// By the columns of a trajectory.csv.
[[nodiscard]] PathFrame path_frame(const Table& table);

/// How far from the foot of the guide, over ground.
[[nodiscard]] double distance_m(const PathPoint& point);

/// The last point at or before this time; null where there is none.
[[nodiscard]] const PathPoint* point_at(const std::vector<PathPoint>& path, double time_s);

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

/// How a rocket turns about all its axes that hands or pins hold, and what was measured of it. Roll is about the long
/// axis, pitch about y, yaw about z of the body.
struct TurnPoint {
  double time_s = 0.0;  ///< on the rows' clock
  double true_roll_rate_rad_s = 0.0;
  double true_pitch_rate_rad_s = 0.0;
  double true_yaw_rate_rad_s = 0.0;
  double true_tilt_rad = 0.0;         ///< of the long axis, from the vertical
  double gyro_roll_rate_rad_s = 0.0;  ///< its last sample, bias and noise in it, as the next two
  double gyro_pitch_rate_rad_s = 0.0;
  double gyro_yaw_rate_rad_s = 0.0;
  double tilt_rad = 0.0;  ///< as the avionics estimates it
};

/// turning.csv: one row a point.
[[nodiscard]] std::string turning_csv(const std::vector<TurnPoint>& turning);

/// The other way. Throws as read_points().
[[nodiscard]] std::vector<TurnPoint> read_turning(const Table& table);

}  // namespace fantail::flight
