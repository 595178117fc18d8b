// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sim/felt_motion.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

/// Hands turn the rocket about an axis of its body: the rate rises from zero and falls back to it as a cosine.
struct HandTurn {
  double time_s = 0.0;      ///< since power-up
  double duration_s = 2.0;  ///< above zero
  Vector3 angle_rad{};      ///< about each axis of the body at once: x to the nose, y, z
};

/// A rocket in a frame of three rings, free to turn about its centre of gravity in still air. It is balanced, so the
/// friction of the bearings holds it wherever the hands leave it, and the canards have no air to turn it with.
class Gimbal {
 public:
  /// The turns outlive it: times increase, none begins before the one ahead of it has ended. The nose points up.
  explicit Gimbal(std::span<const HandTurn> turns) : to_come_{turns} {}

  /// Midpoint rule, the rotation of each step exact. Time at the end of the step, since power-up.
  void step(double time_s, double dt_s);

  [[nodiscard]] const Quaternion& attitude() const { return attitude_; }   ///< from the body to the earth, x up
  [[nodiscard]] double roll_angle_rad() const { return roll_angle_rad_; }  ///< integral of the roll rate
  /// At the centre of gravity, which stands still.
  [[nodiscard]] BodyMotion motion() const;

 private:
  std::span<const HandTurn> to_come_;
  Quaternion attitude_{};
  Vector3 rate_rad_s_{};
  Vector3 acceleration_rad_s2_{};
  double roll_angle_rad_ = 0.0;
};

}  // namespace fantail::sim
