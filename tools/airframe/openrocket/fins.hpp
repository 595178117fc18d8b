// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "airframe/openrocket/component.hpp"
#include "sim/geometry.hpp"

namespace fantail::airframe::openrocket {

/// A fin set of a design, and what it weighs.
struct FoundFins {
  std::string name;
  sim::Geometry::FinSet set;  ///< its position is still missing: it counts from the parent's front
  double first_angle_rad = 0.0;
  sim::Geometry::Mass mass;  ///< likewise
};

[[nodiscard]] bool is_fin_set(const Component& component);

/// Of trapezoidal, elliptical or freeform fins, on a body of this radius. `assumed` gets a sentence where their shape
/// is replaced by a trapezoid of the same area and span, with the same middle.
[[nodiscard]] FoundFins read_fins(const Component& component, double body_radius_m, std::vector<std::string>& assumed);

}  // namespace fantail::airframe::openrocket
