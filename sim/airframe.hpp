// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <optional>

namespace fantail::sim {

/// What moves and turns the long axis of a rocket in the air. Positions count from the tip of the nose towards the
/// tail. The rocket is the same all around its long axis, so pitch and yaw are one.
///
/// Source: J. S. and J. A. Barrowman, The Practical Calculation of the Aerodynamic Characteristics of Slender Finned
/// Vehicles (NASA, 1967): each part makes a normal force in proportion to its local angle of attack, at a place of its
/// own, and the parts are added up.
struct Airframe {
  double diameter_m = 0.0;  ///< of the body, above zero: its cross-section is the area of the slope, and a calibre
  double length_m = 0.0;    ///< above zero
  /// Of all parts, above zero: the normal force at a small angle of attack a is 1/2 rho v^2 times the cross-section
  /// times this times a.
  double normal_force_slope_per_rad = 0.0;
  double centre_of_pressure_m = 0.0;  ///< mean place of the parts, each weighed with its slope
  /// Root mean square distance of the parts from the centre of pressure, weighed the same way, not negative: with the
  /// arm of the centre of pressure it damps pitch.
  double parts_spread_m = 0.0;
  /// The body's own lift grows with the square of the flow across it: coefficient times the area seen from the side,
  /// not negative, and where it acts.
  double body_lift_area_m2 = 0.0;
  double body_lift_position_m = 0.0;

  struct MassProperties {
    double centre_of_gravity_m = 0.0;
    double transverse_inertia_kg_m2 = 0.0;  ///< about the centre of gravity, across the long axis; above zero
  };
  MassProperties at_liftoff{};
  MassProperties after_burnout{};
  std::optional<double> roll_inertia_after_burnout_kg_m2{};  ///< above zero; empty: as at lift-off
  std::optional<double> nozzle_position_m{};  ///< where the exhaust leaves and takes pitch away; empty: at the tail

  [[nodiscard]] constexpr double cross_section_m2() const { return 0.25 * std::numbers::pi * diameter_m * diameter_m; }
};

/// Distance from the centre of gravity back to the centre of pressure: positive is stable.
[[nodiscard]] constexpr double static_margin_m(const Airframe& airframe, const Airframe::MassProperties& mass) {
  return airframe.centre_of_pressure_m - mass.centre_of_gravity_m;
}

}  // namespace fantail::sim
