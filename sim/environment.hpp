// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "sim/ascent.hpp"
#include "sim/burning_rocket.hpp"
#include "sim/felt_motion.hpp"
#include "sim/prescribed_flight.hpp"
#include "sim/random.hpp"
#include "sim/rigid_flight.hpp"
#include "sim/roll_plant.hpp"
#include "sim/scenario.hpp"
#include "sim/wind.hpp"
#include "sim/wind_tunnel.hpp"

namespace fantail::sim {

/// Where the rocket is in six degrees of freedom, or on a prescribed path.
struct Path {
  Vector3 position_m;  ///< earth: north, west, up; from the foot of the guide. Prescribed: across (in the plane of the
                       ///< path, wherever that points), zero, up
  Vector3 velocity_m_s;
  double tilt_rad;             ///< of the axis, from the vertical
  double tilt_from_guide_rad;  ///< of the axis, from where it pointed at rest
  double angle_of_attack_rad;  ///< between the axis and the way through the air; prescribed: zero, because not known
};

/// What surrounds the rocket: a flight along a straight line, in six degrees of freedom or on a path that somebody else
/// has flown, the wind tunnel or the gimbal, seen the same way by plant and sensors.
class Environment {
 public:
  /// The scenario outlives it.
  Environment(const Scenario& scenario, Random turbulence);

  /// Seconds after ignition (negative before it), or after the start command in the tunnel. Times increase.
  void advance_to(double time_s, double roll_rate_rad_s);

  /// As RigidFlight::push_aside, but in the frame of the rolling rocket; in six degrees of freedom only.
  void push_aside(const Vector3& area_m2, double position_m, double roll_angle_rad);

  /// On the gimbal, whose hands count from power-up: its roll at the end of this step; else empty.
  [[nodiscard]] std::optional<RollState> turn_by_hand(double since_power_up_s, double dt_s);

  [[nodiscard]] double density_kg_m3() const {
    return ascent_       ? ascent_->density_kg_m3()
           : flight_     ? flight_->density_kg_m3()
           : prescribed_ ? prescribed_->density_kg_m3()
                         : tunnel_->density_kg_m3();
  }
  [[nodiscard]] double speed_m_s() const {  ///< through the air, along the axis
    return ascent_       ? ascent_->speed_m_s()
           : flight_     ? flight_->air_speed_m_s().x
           : prescribed_ ? prescribed_->speed_m_s()
                         : tunnel_->speed_m_s();
  }
  /// On roll damping and roll torque, at that speed; one where the vehicle has none.
  [[nodiscard]] double compressibility() const {
    return scenario_.vehicle.compressibility == Compressibility::none ? 1.0 : compressibility_here();
  }
  [[nodiscard]] double height_m() const {
    return ascent_ ? ascent_->height_m() : flight_ ? flight_->height_m() : prescribed_ ? prescribed_->height_m() : 0.0;
  }
  /// In flight only: the rocket is past the end of its guide; it stands on the pad or on the ground.
  [[nodiscard]] bool is_clear_of_guide() const;
  [[nodiscard]] bool is_on_ground() const;
  [[nodiscard]] bool can_roll() const;                       ///< no guide holds it
  [[nodiscard]] double fan_rpm() const { return fan_rpm_; }  ///< the set point in force; zero in flight
  [[nodiscard]] double swirl_rad() const { return tunnel_ ? tunnel_->swirl_rad() : 0.0; }
  [[nodiscard]] const AscentEvents& ascent_events() const {  ///< in flight only
    return prescribed_ ? prescribed_->events() : flight_ ? flight_->events() : ascent_->events();
  }
  /// When the parachute began to open; empty: not yet, or there is none.
  [[nodiscard]] bool has_parachute_to_open() const { return flight_ && flight_->has_parachute_to_open(); }
  [[nodiscard]] std::optional<double> parachute_s() const { return flight_ ? flight_->parachute_s() : std::nullopt; }
  /// In flight only: the motor has burnt out, and the rocket sinks or is on the ground. What a motor that pauses does
  /// is still to come.
  [[nodiscard]] bool is_past_apogee() const;
  [[nodiscard]] bool is_over() const { return prescribed_ && prescribed_->is_over(); }  ///< the path has no more
  /// In six degrees of freedom: Twist, of the frame that does not roll.
  [[nodiscard]] std::optional<double> twist_rad() const {
    return flight_ ? std::optional{flight_->twist_rad()} : std::nullopt;
  }
  [[nodiscard]] std::optional<Path> path() const;  ///< empty along a straight line and in the tunnel
  /// It follows the propellant; empty where it does not change.
  [[nodiscard]] std::optional<double> roll_inertia_kg_m2() const;

  [[nodiscard]] std::optional<double> centre_of_gravity_m() const;  ///< from the tip of the nose; empty: not known

  /// At the centre of gravity. Hanging in the tunnel the string carries the rocket: 1 g along the axis.
  [[nodiscard]] BodyMotion motion(const RollState& roll, double roll_acceleration_rad_s2) const;

 private:
  [[nodiscard]] double compressibility_here() const;
  void follow_fan_programme();
  [[nodiscard]] std::optional<BurningRocket> burning() const;

  const Scenario& scenario_;
  std::span<const FanSetPoint> fan_to_come_;
  double fan_rpm_ = 0.0;
  double guide_length_m_;
  std::optional<Ascent> ascent_;
  std::optional<RigidFlight> flight_;
  std::optional<PrescribedFlight> prescribed_;
  std::optional<Wind> wind_;  ///< with the flight
  std::optional<WindTunnel> tunnel_;
  std::optional<PinnedRocket> pinned_;  ///< in the tunnel
  std::optional<Gimbal> gimbal_;        ///< in a tunnel whose fan stands
  Random turbulence_;
  double time_s_ = 0.0;
};

}  // namespace fantail::sim
