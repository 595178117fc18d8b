// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/inputs.hpp"

namespace fantail::core {

/// The truth in double precision: a rocket that moves straight along a tilted guide line while it rolls, and what
/// perfect sensors in it read. Nothing of the product is used.
class MotionRig {
 public:
  struct Setup {
    double tilt_deg = 0.0;
    double azimuth_deg = 0.0;
    double first_roll_deg = 0.0;
    std::array<double, 3> gyro_bias_rad_s{};
  };

  MotionRig() : MotionRig{Setup{}} {}
  explicit MotionRig(const Setup& setup) : setup_{setup} {
    const double tilt = setup.tilt_deg * degree;
    const double azimuth = setup.azimuth_deg * degree;
    axis_ = {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
    // Two axes across, the second the cross product of the rocket's axis with the first.
    across_ = {std::cos(tilt) * std::cos(azimuth), std::cos(tilt) * std::sin(azimuth), -std::sin(tilt)};
    also_across_ = {axis_[1] * across_[2] - axis_[2] * across_[1], axis_[2] * across_[0] - axis_[0] * across_[2],
                    axis_[0] * across_[1] - axis_[1] * across_[0]};
  }

  /// Moves on with a constant acceleration along the guide and a constant roll rate.
  void advance(Microseconds step, double acceleration_m_s2, double roll_rate_rad_s) {
    const double dt_s = static_cast<double>(step.count()) * 1e-6;
    time_ += step;
    acceleration_m_s2_ = acceleration_m_s2;
    roll_rate_rad_s_ = roll_rate_rad_s;
    distance_m_ += (speed_m_s_ + 0.5 * acceleration_m_s2 * dt_s) * dt_s;
    speed_m_s_ += acceleration_m_s2 * dt_s;
    roll_rad_ += roll_rate_rad_s * dt_s;
  }

  [[nodiscard]] Inputs inputs() const {
    const double roll = setup_.first_roll_deg * degree + roll_rad_;
    std::array<double, 3> force{};
    for (std::size_t i = 0; i < 3; ++i) {
      force[i] = acceleration_m_s2_ * axis_[i];
    }
    force[2] += static_cast<double>(standard_gravity_m_s2);
    const double along_y = dot(force, across_) * std::cos(roll) + dot(force, also_across_) * std::sin(roll);
    const double along_z = -dot(force, across_) * std::sin(roll) + dot(force, also_across_) * std::cos(roll);
    const auto& bias = setup_.gyro_bias_rad_s;
    Inputs result;
    result.time = time_;
    result.gyro = {
        time_,
        {static_cast<float>(roll_rate_rad_s_ + bias[0]), static_cast<float>(bias[1]), static_cast<float>(bias[2])},
        SampleQuality::valid};
    result.accelerometers.fill(
        {time_,
         {static_cast<float>(dot(force, axis_)), static_cast<float>(along_y), static_cast<float>(along_z)},
         SampleQuality::valid});
    return result;
  }

  [[nodiscard]] Microseconds time() const { return time_; }
  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] double speed_m_s() const { return speed_m_s_; }
  [[nodiscard]] double height_m() const { return distance_m_ * axis_[2]; }
  [[nodiscard]] double roll_rad() const { return roll_rad_; }

  static constexpr double degree = std::numbers::pi / 180.0;

 private:
  using Axis = std::array<double, 3>;
  static double dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  Setup setup_;
  Axis axis_{};
  Axis across_{};
  Axis also_across_{};
  Microseconds time_{};
  double acceleration_m_s2_ = 0.0;
  double roll_rate_rad_s_ = 0.0;
  double distance_m_ = 0.0;
  double speed_m_s_ = 0.0;
  double roll_rad_ = 0.0;
};

}  // namespace fantail::core
