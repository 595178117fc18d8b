// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "sim/ascent.hpp"
#include "sim/random.hpp"
#include "sim/scenario.hpp"
#include "sim/wind_tunnel.hpp"

namespace fantail::sim {

/// What surrounds the rocket: a flight or the wind tunnel, seen the same way by plant and sensors.
class Environment {
 public:
  /// The scenario outlives it.
  Environment(const Scenario& scenario, Random turbulence);

  /// Seconds after ignition (negative before it), or after the start command in the tunnel. Times increase.
  void advance_to(double time_s);

  [[nodiscard]] double density_kg_m3() const { return ascent_ ? ascent_->density_kg_m3() : tunnel_->density_kg_m3(); }
  [[nodiscard]] double speed_m_s() const { return ascent_ ? ascent_->speed_m_s() : tunnel_->speed_m_s(); }
  [[nodiscard]] double height_m() const { return ascent_ ? ascent_->height_m() : 0.0; }
  [[nodiscard]] double distance_m() const { return ascent_ ? ascent_->distance_m() : 0.0; }
  [[nodiscard]] double fan_rpm() const { return fan_rpm_; }  ///< the set point in force; zero in flight
  [[nodiscard]] double swirl_rad() const { return tunnel_ ? tunnel_->swirl_rad() : 0.0; }
  [[nodiscard]] const AscentEvents& ascent_events() const { return ascent_->events(); }  ///< in flight only

  /// Body frame. Hanging in the tunnel the string carries the rocket: 1 g along the axis.
  [[nodiscard]] Vector3 specific_force_m_s2(double roll_angle_rad) const;

 private:
  void follow_fan_programme();

  std::span<const FanSetPoint> fan_to_come_;
  double fan_rpm_ = 0.0;
  std::optional<Ascent> ascent_;
  std::optional<WindTunnel> tunnel_;
  Random turbulence_;
  double time_s_ = 0.0;
};

}  // namespace fantail::sim
