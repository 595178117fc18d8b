// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::sim {

/// Defaults: the anemometer of Bryson et al. 2016.
struct WindSensor {
  double period_s = 2.0;
  double resolution_m_s = 0.1;  ///< 0: not rounded

  /// What it shows at this speed.
  [[nodiscard]] double shown_m_s(double speed_m_s) const {
    return resolution_m_s > 0.0 ? resolution_m_s * std::round(speed_m_s / resolution_m_s) : speed_m_s;
  }
};

/// One line of a tunnel's log.
struct WindReading {
  double fan_rpm;  ///< the set point in force
  double wind_speed_m_s;
};

}  // namespace fantail::sim
