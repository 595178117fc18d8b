// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "degree.hpp"
#include "sim/gaussian.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

using test::Gaussian;

/// A reading every two seconds from 0 to `end_s`, the end not included.
inline TunnelLog made_tunnel_log(double end_s, const std::function<double(double)>& fan_rpm,
                                 const std::function<double(double)>& wind_speed_m_s) {
  TunnelLog log{.name = "made.csv"};
  for (int i = 0; 2.0 * i < end_s; ++i) {
    log.time_s.push_back(2.0 * i);
    log.fan_rpm.push_back(fan_rpm(2.0 * i));
    log.wind_speed_m_s.push_back(wind_speed_m_s(2.0 * i));
  }
  return log;
}

inline double to_tenths(double value) { return std::round(value * 10.0) / 10.0; }

}  // namespace fantail::tunnel
