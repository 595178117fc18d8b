// SPDX-License-Identifier: MIT
#pragma once

#include "sim/random.hpp"
#include "sim/servo.hpp"

namespace fantail::sim {

/// How much the servos of one vehicle differ from each other. Zeros: all are the same.
struct ServoSpread {
  double share = 0.0;       ///< of lag, delay, rate limit and play: each is multiplied by 1 +- this; 0 to 0.3
  double centre_rad = 0.0;  ///< each centre is off by +- this; 0 to the servo's stop
};

/// One servo off the shelf: evenly spread about `typical`, and inside Servo's ranges where that is. Five numbers are
/// drawn whatever the spread, so that one kind of spread does not change the other.
[[nodiscard]] ServoParameters one_of_the_spread(const ServoParameters& typical, const ServoSpread& spread,
                                                Random& random);

}  // namespace fantail::sim
