// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "sim/felt_motion.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

/// Hands turn the rocket about an axis of its body: the rate rises from zero and falls back to it as a cosine.
struct HandTurn {
  double time_s = 0.0;      ///< since power-up
  double duration_s = 2.0;  ///< above zero
  Vector3 angle_rad{};      ///< about each axis of the body at once: x to the nose, y, z
};

/// What the rocket does when hands have let go of it.
struct FreeTurning {
  double roll_inertia_kg_m2;        ///< above zero
  double transverse_inertia_kg_m2;  ///< above zero
  double friction_n_m;              ///< of the bearings, against the rate, whatever its size
};

/// A rocket in a frame of three rings, free to turn about its centre of gravity in still air. It is balanced, and the
/// canards have no air to turn it with. The rings weigh nothing.
class Gimbal {
 public:
  /// The turns outlive it: times increase, none begins before the one ahead of it has ended. The nose points up.
  /// `free`: hands let go half-way through each turn, when it is fastest, and bring the rocket to a stop when the next
  /// turn begins. Empty: they hold it to the end of each turn, and leave it at rest.
  explicit Gimbal(std::span<const HandTurn> turns, std::optional<FreeTurning> free = {})
      : to_come_{turns}, free_{free} {}

  /// Midpoint rule, the rotation of each step exact. Time at the end of the step, since power-up.
  void step(double time_s, double dt_s);

  [[nodiscard]] const Quaternion& attitude() const { return attitude_; }   ///< from the body to the earth, x up
  [[nodiscard]] double roll_angle_rad() const { return roll_angle_rad_; }  ///< integral of the roll rate
  /// At the centre of gravity, which stands still.
  [[nodiscard]] BodyMotion motion() const;

 private:
  void turn_by_hand(const HandTurn& hands, double time_s, double dt_s);
  void turn_freely(double dt_s);
  void turn_on(const Vector3& middle_rad_s, double dt_s);

  std::span<const HandTurn> to_come_;
  std::optional<FreeTurning> free_;
  Quaternion attitude_{};
  Vector3 rate_rad_s_{};
  Vector3 acceleration_rad_s2_{};
  double roll_angle_rad_ = 0.0;
};

}  // namespace fantail::sim
