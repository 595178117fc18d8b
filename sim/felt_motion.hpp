// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/units.hpp"
#include "sim/vibration.hpp"

namespace fantail::sim {

/// How a rocket moves, in its body frame, at its centre of gravity or where a sensor sits.
struct BodyMotion {
  Vector3 specific_force_m_s2;
  Vector3 rate_rad_s;
  Vector3 angular_acceleration_rad_s2;
};

/// Where an inertial sensor sits and what it makes of the motion before it converts it. Nothing by default.
struct FeltMotionParameters {
  std::optional<double> position_m{};  ///< from the tip of the nose; empty: at the centre of gravity
  double across_m = 0.0;               ///< from the long axis, towards y
  double rate_scale_error = 0.0;       ///< share of every rate
  double specific_force_scale_error = 0.0;
  double rate_per_specific_force_s_m = 0.0;  ///< g-sensitivity of the gyro: rad/s per m/s2 of the same axis
  double rate_drift_rad_s2 = 0.0;            ///< of the gyro's bias since power-up, as it warms: rad/s per second

  bool operator==(const FeltMotionParameters&) const = default;
};

/// In this order:
///   1. where the sensor sits: f + w' x r + w x (w x r) for its arm r from the centre of gravity;
///   2. the vibration there. It comes after the arm, on which rates that shake would pull all along;
///   3. scale errors, and the gyro's g-sensitivity and drift.
/// What follows is the converter's: misalignment, bias, noise, rounding (TriaxialConverter).
///
/// Example: 0.02 m off the axis of a rocket that spins with 10 rad/s, an accelerometer reads 0.02 * 10^2 = 2 m/s2
/// inwards, that is -2 m/s2 along y; with a scale error of 1 % it reads -2.02.
class FeltMotion {
 public:
  explicit FeltMotion(const FeltMotionParameters& parameters);

  /// The sensor sits at the centre of gravity and has none of these errors: what it feels is the motion itself.
  [[nodiscard]] bool is_ideal() const { return is_ideal_; }

  /// `centre_of_gravity_m` from the tip of the nose; empty: nobody knows, and `position_m` does not count. Time since
  /// power-up.
  [[nodiscard]] BodyMotion felt(const BodyMotion& motion, const Shaking& shaking,
                                std::optional<double> centre_of_gravity_m, double time_s) const;

 private:
  FeltMotionParameters parameters_;
  bool is_ideal_;
};

}  // namespace fantail::sim
