// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Box-Muller on the test's own generator.
class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : random_{seed} {}
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 random_;
};

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
