// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "sim/geometry.hpp"

namespace fantail::airframe::openrocket {

/// A round body along the axis: from where to where, its outer radius there, and how thick its wall is (measured square
/// to its surface; at least the radius: it is full).
struct Solid {
  double begin_m = 0.0;
  double length_m = 0.0;
  std::function<double(double)> radius_m;  ///< of the distance from its begin
  double wall_m = 0.0;
  double density_kg_m3 = 0.0;
};

/// Mass, middle, length and radius of gyration. Its length is what makes the transverse inertia right, not its own.
[[nodiscard]] sim::Geometry::Mass mass_of(const Solid& solid);

/// One part in the place of several.
[[nodiscard]] sim::Geometry::Mass together(const sim::Geometry::Mass& a, const sim::Geometry::Mass& b);

/// What stands for a cone or a swept fin may be a little longer than it is: as long as it may be within the rocket.
void shorten_to_rocket(sim::Geometry::Mass& part, double rocket_length_m);

}  // namespace fantail::airframe::openrocket
