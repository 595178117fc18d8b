// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace fantail::sim {

/// Can a rocket roll in its guide?
enum class GuideRoll : std::uint8_t {
  free,  ///< a tower: it can
  held,  ///< a rail with buttons: it cannot
};

/// What leads a rocket until it is fast enough to fly.
struct LaunchGuide {
  std::optional<double> length_m{};  ///< empty: as the plan believes
  double tilt_rad = 0.0;             ///< from the vertical, below a right angle
  double azimuth_rad = 0.0;          ///< where it leans to: 0 north, a quarter of a turn east
  double friction = 0.0;             ///< force along the guide over the force across it
  double tip_off_rad_s = 0.0;  ///< pitch rate with which the rocket leaves, towards the side that the guide leans to
  GuideRoll roll = GuideRoll::free;
};

}  // namespace fantail::sim
