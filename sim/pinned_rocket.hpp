// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sim/airframe.hpp"
#include "sim/felt_motion.hpp"

namespace fantail::sim {

/// A push that turns the rocket about its pins from one instant to the next.
struct Kick {
  double time_s;  ///< after the start command
  double rate_rad_s;
};

/// How a rocket is pinned in the tunnel: two strings hold it across the wind near its centre of gravity.
struct PinParameters {
  double in_front_m = 0.0;             ///< of the pins before the centre of gravity: what hangs below helps
  double stiffness_n_m_per_rad = 0.0;  ///< of the strings, which twist
  double friction_n_m_s = 0.0;         ///< of the strings, per rate
  double tether_slack_rad = 0.7;       ///< beyond this a safety tether pulls back
  double tether_n_m_per_rad = 20.0;    ///< with this stiffness
  double wall_rad = 1.2;               ///< the wall of the tunnel stops the rocket here
  std::vector<Kick> kicks;             ///< times increase
};

/// A rocket in a vertical tunnel, its nose into the wind, free to pitch about its pins and held in roll. Its motor is
/// not in it or has not burnt: mass and inertia are those at lift-off.
class PinnedRocket {
 public:
  /// The parameters outlive it.
  PinnedRocket(const PinParameters& pin, const Airframe& airframe, double mass_kg);

  /// Midpoint rule with air speed and density held. Time at the end of the step, after the start command.
  void step(double time_s, double dt_s, double density_kg_m3, double speed_m_s);

  [[nodiscard]] double angle_rad() const { return angle_rad_; }  ///< of the nose from the wind
  [[nodiscard]] double rate_rad_s() const { return rate_rad_s_; }
  [[nodiscard]] double pin_position_m() const { return pin_position_m_; }  ///< from the tip of the nose
  /// At the pins, which stand still.
  [[nodiscard]] BodyMotion motion() const;

 private:
  [[nodiscard]] double acceleration_rad_s2(double angle_rad, double rate_rad_s, double density_kg_m3,
                                           double speed_m_s) const;

  const PinParameters& pin_;
  const Airframe& airframe_;
  double mass_kg_;
  double pin_position_m_;
  double inertia_kg_m2_;  ///< about the pins
  std::span<const Kick> kicks_to_come_;
  double angle_rad_ = 0.0;
  double rate_rad_s_ = 0.0;
  double acceleration_rad_s2_ = 0.0;
};

}  // namespace fantail::sim
