// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "text/degrees.hpp"

namespace fantail::text {

/// From north over east, in whole degrees: 0 to 359.
[[nodiscard]] inline long bearing_deg(double radians) {
  const long whole = std::lround(degrees(radians)) % 360;
  return whole < 0 ? whole + 360 : whole;
}

/// The same direction, which no rounding to whole degrees makes 360.
[[nodiscard]] inline double bearing_rad(double radians) { return bearing_deg(radians) == 0 ? 0.0 : radians; }

}  // namespace fantail::text
