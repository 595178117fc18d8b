// SPDX-License-Identifier: MIT
#include "airframe/openrocket/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;

double square(double x) { return x * x; }

/// A rod's length squared over twelve is what its masses are away from its middle, squared, in the mean.
double mean_square_m2(const Geometry::Mass& part, double about_m) {
  return square(part.length_m) / 12.0 + square(part.position_m - about_m);
}

}  // namespace

Geometry::Mass mass_of(const Solid& solid) {
  constexpr int slices = 2000;
  double mass_kg = 0.0;
  double moment_kg_m = 0.0;
  double second_kg_m2 = 0.0;
  double roll_kg_m2 = 0.0;
  const double step_m = solid.length_m / slices;
  for (int i = 0; i < slices; ++i) {
    const double along_m = (static_cast<double>(i) + 0.5) * step_m;
    const double outer_m = solid.radius_m(along_m);
    const double slope =
        (solid.radius_m(static_cast<double>(i + 1) * step_m) - solid.radius_m(static_cast<double>(i) * step_m)) /
        step_m;
    const double inner_m = std::max(0.0, outer_m - solid.wall_m * std::hypot(1.0, slope));
    const double slice_kg = solid.density_kg_m3 * std::numbers::pi * (square(outer_m) - square(inner_m)) * step_m;
    mass_kg += slice_kg;
    moment_kg_m += slice_kg * along_m;
    second_kg_m2 += slice_kg * square(along_m);
    roll_kg_m2 += slice_kg * 0.5 * (square(outer_m) + square(inner_m));
  }
  if (!(mass_kg > 0.0)) {
    return {.name = {}, .position_m = solid.begin_m + 0.5 * solid.length_m, .length_m = solid.length_m};
  }
  const double middle_m = moment_kg_m / mass_kg;
  const double spread_m2 = std::max(0.0, second_kg_m2 / mass_kg - square(middle_m));
  return {.name = {},
          .mass_kg = mass_kg,
          .position_m = solid.begin_m + middle_m,
          .length_m = std::sqrt(12.0 * spread_m2),
          .radius_of_gyration_m = std::sqrt(roll_kg_m2 / mass_kg)};
}

Geometry::Mass together(const Geometry::Mass& a, const Geometry::Mass& b) {
  const double mass_kg = a.mass_kg + b.mass_kg;
  if (!(mass_kg > 0.0)) {
    return a;
  }
  const double middle_m = (a.mass_kg * a.position_m + b.mass_kg * b.position_m) / mass_kg;
  const double spread_m2 =
      (a.mass_kg * mean_square_m2(a, middle_m) + b.mass_kg * mean_square_m2(b, middle_m)) / mass_kg;
  const double roll_m2 =
      (a.mass_kg * square(a.radius_of_gyration_m) + b.mass_kg * square(b.radius_of_gyration_m)) / mass_kg;
  return {.name = a.name,
          .mass_kg = mass_kg,
          .position_m = middle_m,
          .length_m = std::sqrt(12.0 * spread_m2),
          .radius_of_gyration_m = std::sqrt(roll_m2)};
}

void shorten_to_rocket(Geometry::Mass& part, double rocket_length_m) {
  const double room_m = std::max(0.0, std::min(part.position_m, rocket_length_m - part.position_m));
  part.length_m = std::min(part.length_m, 2.0 * room_m);
}

}  // namespace fantail::airframe::openrocket
