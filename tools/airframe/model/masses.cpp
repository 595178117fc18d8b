// SPDX-License-Identifier: MIT
#include "airframe/model/masses.hpp"

namespace fantail::airframe::model {

MassSum sum_of(const std::vector<sim::Geometry::Mass>& parts) {
  MassSum sum;
  double moment_kg_m = 0.0;
  for (const sim::Geometry::Mass& part : parts) {
    sum.mass_kg += part.mass_kg;
    moment_kg_m += part.mass_kg * part.position_m;
    sum.roll_inertia_kg_m2 += part.mass_kg * part.radius_of_gyration_m * part.radius_of_gyration_m;
  }
  sum.centre_of_gravity_m = moment_kg_m / sum.mass_kg;
  for (const sim::Geometry::Mass& part : parts) {
    const double away_m = part.position_m - sum.centre_of_gravity_m;
    const double own_m2 =
        part.length_m * part.length_m / 12.0 + 0.5 * part.radius_of_gyration_m * part.radius_of_gyration_m;
    sum.transverse_inertia_kg_m2 += part.mass_kg * (own_m2 + away_m * away_m);
  }
  return sum;
}

}  // namespace fantail::airframe::model
