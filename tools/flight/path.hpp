// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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

}  // namespace fantail::flight
