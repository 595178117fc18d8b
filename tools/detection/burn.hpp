// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "detection/event_models.hpp"
#include "detection/motion.hpp"

namespace fantail::detection {

/// Thrust over mass.
struct Burn {
  double peak;
  double rise_s;
  double sag_per_s;  ///< share of the peak
  double burn_s;
  double least;  ///< from the rise to the end

  [[nodiscard]] double at(double t) const {
    if (t < 0.0 || t > burn_s) {
      return 0.0;
    }
    if (t < rise_s) {
      return peak * t / rise_s;
    }
    return std::max(least, peak * (1.0 - sag_per_s * (t - rise_s)));
  }
};

/// Vibration along and across the axis while it burns.
struct BurnVibration {
  double rms_m_s2;
  double frequency_hz;
};

/// Up the guide and on, straight along the axis, whose pitch is this, from step `first` to the end of the motion, or to
/// the highest point where that comes before; which of them it was. Ignition is in step `ignition`.
std::size_t rise(const Burn& burn, const BurnVibration& vibration, double pitch_rad, std::size_t first,
                 std::size_t ignition, Streams& streams, Motion& motion, bool all);

}  // namespace fantail::detection
