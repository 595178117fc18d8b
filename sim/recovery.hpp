// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::sim {

/// A parachute. Nothing opens it but that the rocket sinks for the first time: mostly that is apogee.
struct Recovery {
  double delay_s = 0.0;         ///< from there to the opening
  double opening_time_s = 0.5;  ///< until the parachute is full, above zero
  double drag_area_m2 = 0.5;    ///< of the parachute
  double position_m = 0.0;      ///< where its line holds the rocket, from the tip of the nose
};

}  // namespace fantail::sim
