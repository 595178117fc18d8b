// SPDX-License-Identifier: MIT
#pragma once

#include "sim/units.hpp"

namespace fantail::sim {

/// What a canard of this vehicle may show on the bench and still fly. Angles are those of its shaft.
struct CanardTolerances {
  double reach_rad = 0.5 * radians_per_degree;     ///< at a limit: encoder against command
  double tracking_rad = 1.0 * radians_per_degree;  ///< during a slow ramp: encoder against command, servo lag taken off
  double centring_rad = 0.5 * radians_per_degree;  ///< at rest: mean of both approaches against command
  double backlash_rad = 0.5 * radians_per_degree;  ///< at rest: difference of the two approaches
  double slowest_slew_rad_s = 300 * radians_per_degree;  ///< from one limit to the other
  double longest_step_time_s = 0.08;                     ///< 10 to 90 % of a step from the centre to a limit
  double noise_rad = 0.15 * radians_per_degree;          ///< standard deviation of the encoder at rest
  double dropout_share = 0.001;                          ///< of the encoder's readings that were not valid
};

}  // namespace fantail::sim
