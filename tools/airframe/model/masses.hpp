// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/geometry.hpp"

namespace fantail::airframe::model {

struct MassSum {
  double mass_kg = 0.0;
  double centre_of_gravity_m = 0.0;       ///< from the tip of the nose
  double transverse_inertia_kg_m2 = 0.0;  ///< about the centre of gravity
  double roll_inertia_kg_m2 = 0.0;
};

/// Of parts that are round about the long axis; at least one has a mass.
[[nodiscard]] MassSum sum_of(const std::vector<sim::Geometry::Mass>& parts);

}  // namespace fantail::airframe::model
