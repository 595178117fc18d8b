// SPDX-License-Identifier: MIT
#include "sim/wind_tunnel.hpp"

#include <cmath>

#include "sim/elementary.hpp"

namespace fantail::sim {

WindTunnel::WindTunnel(const WindTunnelParameters& parameters, double unit_gaussian)
    : parameters_{parameters},
      set_point_m_s_{parameters.fan_rpm * parameters.speed_per_rpm_m_s},
      mean_m_s_{set_point_m_s_},
      gust_{unit_gaussian} {}

double WindTunnel::step(double dt_s, double unit_gaussian) {
  // Steps that are differences of two times differ in their last digits, which would cost an exponential each.
  if (!(std::abs(dt_s - dt_s_) <= 1e-9 * dt_s_)) {
    dt_s_ = dt_s;
    fan_gain_ = settling(dt_s / parameters_.fan_lag_s).gain;
    gust_decay_ = exponential(-dt_s / parameters_.turbulence_time_s);
    // Keeps the variance at one whatever the step.
    gust_gain_ = std::sqrt(settling(2.0 * dt_s / parameters_.turbulence_time_s).gain);
  }
  mean_m_s_ += fan_gain_ * (set_point_m_s_ - mean_m_s_);
  gust_ = gust_decay_ * gust_ + gust_gain_ * unit_gaussian;
  return speed_m_s();
}

}  // namespace fantail::sim
