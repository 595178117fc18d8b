// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flight/table.hpp"

namespace fantail::flight {

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
