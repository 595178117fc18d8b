// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "sim/air_loads.hpp"
#include "sim/airframe.hpp"
#include "sim/ascent.hpp"
#include "sim/compressibility.hpp"
#include "sim/drag_over_mach.hpp"
#include "sim/highest_point.hpp"
#include "sim/launch_guide.hpp"
#include "sim/local_density.hpp"
#include "sim/recovery.hpp"
#include "sim/rigid_body.hpp"
#include "sim/thrust_curve.hpp"
#include "sim/twist.hpp"

namespace fantail::sim {

struct RigidFlightParameters {
  double mass_kg = 0.0;  ///< at ignition, propellant included; above that of the propellant
  double drag_area_m2 = 0.0;
  double roll_inertia_kg_m2 = 0.0;  ///< at lift-off
  Airframe airframe{};
  LaunchGuide guide{};
  double guide_length_m = 4.0;  ///< whatever the guide says of it
  Atmosphere atmosphere{};
  ThrustCurve motor{};
  std::optional<Recovery> recovery{};  ///< empty: it falls as it flew
  DragOverMach drag_over_mach{};       ///< factor on the drag area
  Compressibility compressibility = Compressibility::none;
};

/// A rocket from the pad to the ground in six degrees of freedom, but for its roll, which is the roll plant's. Without
/// wind and on a vertical guide it moves as Ascent does.
///
/// Pad and guide hold the axis where it is and carry what acts across it. Beyond the guide thrust, air, gravity and
/// jet damping move it; the mass, its centre and its inertia follow the propellant: mass and first moment in
/// proportion to the impulse, the inertia about the centre of gravity too, which is an approximation.
class RigidFlight {
 public:
  /// On the pad, before ignition.
  explicit RigidFlight(const RigidFlightParameters& parameters);

  /// As Ascent::advance_to. The wind (earth: north, west, up) is that at the end of the step and changes evenly to it.
  /// The roll rate is that at the begin, and only turns the axis as a gyroscope.
  void advance_to(double time_s, double roll_rate_rad_s, const Vector3& wind_m_s);

  /// What pushes across the axis from now on, beside the flow across it: a force of 1/2 rho v^2 times this at that
  /// distance from the tip of the nose; frame of the rocket, y and z.
  void push_aside(const Vector3& area_m2, double position_m) {
    push_area_m2_ = area_m2;
    push_position_m_ = position_m;
  }

  [[nodiscard]] const RigidState& state() const { return state_; }
  [[nodiscard]] double height_m() const { return state_.position_m.z; }
  [[nodiscard]] double speed_m_s() const { return length(state_.velocity_m_s); }  ///< over ground
  [[nodiscard]] const Vector3& air_speed_m_s() const { return air_speed_m_s_; }   ///< frame of the rocket
  [[nodiscard]] double tilt_rad() const;                                          ///< of the axis, from the vertical
  [[nodiscard]] double tilt_from_guide_rad() const;                               ///< of the axis, from the guide
  [[nodiscard]] double twist_rad() const { return twist_.rad(); }                 ///< of its frame, since the pad
  [[nodiscard]] double mass_kg() const { return body_.inertia.mass_kg; }
  [[nodiscard]] double roll_inertia_kg_m2() const { return body_.inertia.roll_kg_m2; }
  [[nodiscard]] double centre_of_gravity_m() const { return body_.centre_of_gravity_m; }
  [[nodiscard]] double density_kg_m3() const { return density_kg_m3_; }  ///< of the air at height_m()
  [[nodiscard]] double distance_m() const { return distance_m_; }        ///< along the guide, until it is left
  [[nodiscard]] bool is_clear_of_guide() const { return stage_ == Stage::free || stage_ == Stage::landed; }
  [[nodiscard]] bool is_on_ground() const { return stage_ == Stage::pad || stage_ == Stage::landed; }
  [[nodiscard]] bool guide_holds_roll() const {
    return parameters_.guide.roll == GuideRoll::held && !is_clear_of_guide();
  }
  [[nodiscard]] const AscentEvents& events() const { return events_; }
  [[nodiscard]] std::optional<double> parachute_s() const { return parachute_s_; }  ///< when it began to open
  [[nodiscard]] bool has_parachute_to_open() const {
    return parameters_.recovery && parameters_.recovery->drag_area_m2 > 0.0 && !parachute_s_ && !is_on_ground();
  }

  /// What an accelerometer at the centre of gravity reads, and how the rocket turns; frame of the rocket.
  [[nodiscard]] const Vector3& specific_force_m_s2() const { return specific_force_m_s2_; }
  [[nodiscard]] const Vector3& angular_acceleration_rad_s2() const { return now_.acceleration_rad_s2; }

 private:
  enum class Stage : std::uint8_t { pad, guide, free, landed };

  /// What follows from how much propellant is left.
  struct Body {
    Inertia inertia;
    double centre_of_gravity_m;
    double jet_damping_n_m_s;  ///< moment per pitch rate
    double thrust_n;
  };
  [[nodiscard]] Body body_at(double time_s) const;
  [[nodiscard]] Vector3 through_air_m_s(const RigidState& state, const Vector3& wind_m_s) const;
  [[nodiscard]] Loads loads(const Body& body, const RigidState& state, double time_s, double density_kg_m3,
                            const Vector3& wind_m_s) const;
  void add_parachute(Loads& loads, const Body& body, const Vector3& air_speed_m_s, const Vector3& rate_rad_s,
                     double time_s, double density_kg_m3) const;
  /// What the guide leaves of the loads, per mass; along the axis.
  [[nodiscard]] double axial_in_guide_m_s2(const Loads& loads, const Body& body, double speed_m_s) const;
  void wait_on_pad(double time_s, const Vector3& wind_m_s);
  void slide(double time_s, const Vector3& wind_m_s);
  void fly(double time_s, double roll_rate_rad_s, const Vector3& wind_m_s);
  void come_to_rest();
  /// Everything that follows from state_ at this instant.
  void look(double time_s, double roll_rate_rad_s, double density_kg_m3, const Vector3& wind_m_s);

  RigidFlightParameters parameters_;
  double burnt_per_n_s_;           ///< share of the propellant per impulse
  Vector3 gravity_in_guide_m_s2_;  ///< frame of the rocket
  LocalDensity density_;
  double time_s_ = 0.0;
  double density_kg_m3_;
  double distance_m_ = 0.0;
  double guide_speed_m_s_ = 0.0;
  Vector3 wind_m_s_;
  Vector3 push_area_m2_{};
  double push_position_m_ = 0.0;
  Stage stage_ = Stage::pad;
  RigidState state_{};
  Twist twist_;
  Body body_{};
  RateOfChange now_{};
  Vector3 specific_force_m_s2_;
  Vector3 air_speed_m_s_;
  AscentEvents events_;
  HighestPoint highest_;
  std::optional<double> first_sank_s_;  ///< what opens the parachute, whatever the motor does later
  std::optional<double> parachute_s_;
};

}  // namespace fantail::sim
