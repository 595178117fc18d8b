// SPDX-License-Identifier: MIT
#pragma once

#include "sim/geometry.hpp"

namespace fantail::airframe::model {

/// What a set of fins does in air of small angles, well below the speed of sound. Areas and volumes instead of
/// coefficients: no reference area is in them.
///
/// Source: J. S. Barrowman, The Practical Calculation of the Aerodynamic Characteristics of Slender Finned Vehicles
/// (NASA, 1967), with the interference factors of fins and body given there; the slope of one fin is that of Diederich.
/// S. Niskanen, OpenRocket technical documentation, gives the loss of more than four fins.
struct FinForces {
  double one_fin_area_m2 = 0.0;     ///< lift of one fin alone: 1/2 rho v^2 times this times its angle
  double slope_area_m2 = 0.0;       ///< normal force of all, lift on the body between them included, likewise
  double position_m = 0.0;          ///< where it acts, from the tip of the nose
  double arm_m = 0.0;               ///< where the lift of one fin acts, from the long axis
  double roll_torque_m3 = 0.0;      ///< all turned by an angle: torque 1/2 rho v^2 times this times it
  double roll_damping_m4 = 0.0;     ///< at a roll rate p: torque -1/2 rho v times this times p
  double mean_chord_m = 0.0;        ///< the aerodynamic one
  double mean_chord_front_m = 0.0;  ///< its leading edge, behind that of the root
};

/// `body_radius_m`: where the fins are, above zero.
[[nodiscard]] FinForces fin_forces(const sim::Geometry::FinSet& fins, double body_radius_m);

}  // namespace fantail::airframe::model
