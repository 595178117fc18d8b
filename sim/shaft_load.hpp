// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::sim {

/// What the air does to the shaft of a canard: a moment in proportion to the angle from where there is none. Above zero
/// it turns the shaft back there; below zero, as where the air acts in front of the shaft, away from there.
struct ShaftLoad {
  double stiffness_n_m_per_rad = 0.0;
  double free_angle_rad = 0.0;

  /// On a shaft at this angle, in the sense of its angle.
  [[nodiscard]] double moment_n_m(double shaft_rad) const {
    return -stiffness_n_m_per_rad * (shaft_rad - free_angle_rad);
  }
};

/// How fast a loaded servo can turn; each speed counts from the smaller to the larger angle, and least is not more than
/// most.
struct ServoSpeeds {
  double least_rad_s;
  double most_rad_s;
};

/// A motor with a straight line from its free speed to its stall torque, and a gear that lets a load push it backwards:
/// against a load the speed is the rate limit times 1 - load / torque, beyond the torque that is backwards, and a load
/// that helps makes nothing faster, unless it is more than the motor could hold back.
[[nodiscard]] constexpr ServoSpeeds speeds_under_load(double rate_limit_rad_s, double moment_over_torque) {
  // In the sense of the load.
  const double load = moment_over_torque < 0.0 ? -moment_over_torque : moment_over_torque;
  const double least_rad_s = rate_limit_rad_s * (load - 1.0);
  const double most_rad_s = load > 2.0 ? least_rad_s : rate_limit_rad_s;
  return moment_over_torque < 0.0 ? ServoSpeeds{-most_rad_s, -least_rad_s} : ServoSpeeds{least_rad_s, most_rad_s};
}

}  // namespace fantail::sim
