// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "airframe/model/body.hpp"
#include "airframe/model/fin_set.hpp"
#include "sim/vehicle.hpp"

namespace fantail::airframe::model {

/// A computed number and how far the truth may be from it.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// What one part of the rocket adds to the normal force.
struct Part {
  std::string name;
  double slope_per_rad = 0.0;  ///< on the body's cross-section
  double position_m = 0.0;
};

/// The numbers of a vehicle file as they follow from its shape and its parts' masses: what a team has before any
/// tunnel.
///
/// The ranges are those of the method, not of the measurements that went in: the normal force within 10 % (Barrowman
/// found 6 % on his rockets; OpenRocket finds it "notably" low on the Arcas Robin), the centre of pressure within 3 %
/// of its distance from the nose ("a few percent", the same comparison), and roll within a factor of two (OpenRocket's
/// only flight with canted fins rolled at 16 turns a second instead of about 8). Canards ahead of fins may lose all of
/// their torque to them, so that the low end of theirs is zero there, and what they need against a cant has no high
/// end: infinity.
struct BuildUp {
  std::vector<Part> parts;
  Estimate normal_force_slope_per_rad;
  Estimate centre_of_pressure_m;
  /// Of the plane through the long axis in which the rocket holds its direction least, where fins are one or two;
  /// centre_of_pressure_m is the mean over all planes then.
  std::optional<Estimate> worst_centre_of_pressure_m;
  double parts_spread_m = 0.0;
  double body_lift_area_m2 = 0.0;
  double body_lift_position_m = 0.0;
  Estimate roll_damping_m4;                 ///< A alpha
  std::optional<Estimate> roll_torque_m3;   ///< A beta; empty without canards
  std::optional<double> canard_arm_m;       ///< from the long axis to where a canard lifts
  std::optional<Estimate> hinge_moment_m3;  ///< one canard: 1/2 rho v^2 times this times its angle, positive: closes
  std::optional<Estimate> cant_as_canards;  ///< canard angle that rolls as one radian of fin cant does
  double canted_torque_m3 = 0.0;            ///< of all fins' cants: torque 1/2 rho v^2 times this
  std::optional<MassSum> after_burnout;     ///< empty without masses
  std::optional<MassSum> at_liftoff;        ///< empty too where the place of the propellant is not known
};

/// That of the worst plane, where planes differ.
[[nodiscard]] inline const Estimate& least_centre_of_pressure_m(const BuildUp& b) {
  return b.worst_centre_of_pressure_m ? *b.worst_centre_of_pressure_m : b.centre_of_pressure_m;
}

/// The vehicle has a geometry.
[[nodiscard]] BuildUp build_up(const sim::Vehicle& vehicle);

}  // namespace fantail::airframe::model
