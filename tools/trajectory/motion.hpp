// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "trajectory/series.hpp"

namespace fantail::trajectory {

/// How the rocket of a series moves in the plane in which it leans, at each row.
struct Motion {
  std::vector<double> up_m_s;          ///< over ground
  std::vector<double> across_m_s;      ///< over ground
  std::vector<double> along_axis_m_s;  ///< through the air
  std::vector<double> tilt_rad;        ///< of the axis, from the vertical
  std::vector<double> felt_m_s2;       ///< along the axis, gravity taken off; empty: it follows from the speeds
  std::vector<Quantity> read;          ///< from the file
  std::vector<std::string> derived;    ///< words for a person: "the tilt is that of the path"
};

/// What is not in the series follows from what is, as parse_trajectory() says; the tilt of the guide stands in for one
/// that nothing tells. Up to lift-off the rocket is at rest.
[[nodiscard]] Motion motion_of(const Series& series, double guide_tilt_rad);

}  // namespace fantail::trajectory
