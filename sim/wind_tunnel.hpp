// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::sim {

/// Defaults: the tunnel of Bryson et al. 2016 at 22 m/s, without turbulence and swirl.
struct WindTunnelParameters {
  double fan_rpm = 1250.0;
  double speed_per_rpm_m_s = 0.0176;  ///< measured: linear over all set points (R2 0.9999), 30 m/s at 1700 rpm
  double turbulence = 0.0;            ///< standard deviation over mean of the speed
  double turbulence_time_s = 0.5;     ///< correlation time, above zero; assumed
  double fan_lag_s = 5.0;             ///< time constant of the speed after a new set point, above zero; assumed
  double swirl_rad = 0.0;             ///< canard deflection that makes the same roll moment, at any speed
  double density_kg_m3 = 1.2;
};

/// A vertical wind tunnel with the rocket on a string, free to roll. The mean speed follows the fan's set point with a
/// first-order lag; turbulence is an Ornstein-Uhlenbeck process around it, exact for every step length.
class WindTunnel {
 public:
  /// In steady state at the fan's set point. `unit_gaussian` draws the turbulence at the start.
  explicit WindTunnel(const WindTunnelParameters& parameters, double unit_gaussian = 0.0);

  /// The air speed `dt_s` (above zero) later. Takes independent samples of mean 0 and standard deviation 1. With strong
  /// turbulence a gust may blow backwards.
  double step(double dt_s, double unit_gaussian);

  /// Takes effect from the next step on.
  void set_fan_rpm(double fan_rpm) { set_point_m_s_ = fan_rpm * parameters_.speed_per_rpm_m_s; }

  [[nodiscard]] double speed_m_s() const { return mean_m_s_ * (1.0 + parameters_.turbulence * gust_); }
  [[nodiscard]] double mean_speed_m_s() const { return mean_m_s_; }  ///< without turbulence
  [[nodiscard]] double density_kg_m3() const { return parameters_.density_kg_m3; }
  /// To be added to the disturbance of the airframe.
  [[nodiscard]] double swirl_rad() const { return parameters_.swirl_rad; }

 private:
  WindTunnelParameters parameters_;
  double set_point_m_s_;
  double mean_m_s_;
  double gust_;  ///< in standard deviations
  // What depends on the step length only, which hardly ever changes by more than rounding.
  double dt_s_ = 0.0;
  double fan_gain_ = 0.0;
  double gust_decay_ = 1.0;
  double gust_gain_ = 0.0;
};

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
