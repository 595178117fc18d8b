// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "sim/geometry.hpp"

namespace fantail::airframe::model {

/// What the body without fins does at small angles, and what is seen of it from the side.
struct BodyForces {
  double nose_slope_area_m2 = 0.0;  ///< normal force: 1/2 rho v^2 times this times the angle of attack
  double nose_position_m = 0.0;     ///< where it acts
  struct Part {
    double slope_area_m2 = 0.0;  ///< negative where the body gets thinner
    double position_m = 0.0;
  };
  std::vector<Part> transitions;  ///< those that change the diameter, from nose to tail
  double side_area_m2 = 0.0;
  double side_area_position_m = 0.0;  ///< its middle
};

/// Slender-body theory (Barrowman 1967): a part's force is twice the change of its cross-section.
[[nodiscard]] BodyForces body_forces(const sim::Geometry& shape);

/// Of the body, at a place from the tip of the nose to the tail.
[[nodiscard]] double radius_m(const sim::Geometry& shape, double position_m);

/// Of the body: a calibre.
[[nodiscard]] double largest_diameter_m(const sim::Geometry& shape);

struct MassSum {
  double mass_kg = 0.0;
  double centre_of_gravity_m = 0.0;       ///< from the tip of the nose
  double transverse_inertia_kg_m2 = 0.0;  ///< about the centre of gravity
  double roll_inertia_kg_m2 = 0.0;
};

/// Of parts that are round about the long axis; at least one has a mass.
[[nodiscard]] MassSum sum_of(const std::vector<sim::Geometry::Mass>& parts);

}  // namespace fantail::airframe::model
