// SPDX-License-Identifier: MIT
#include "airframe/model/body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fantail::airframe::model {
namespace {

using sim::Geometry;

using std::numbers::pi;

/// Radius of the nose over that of its base, at a share `x` of its length from the tip.
double nose_profile(Geometry::NoseShape shape, double x, double length_over_radius) {
  switch (shape) {
    case Geometry::NoseShape::cone: return x;
    case Geometry::NoseShape::ogive: {  // an arc that touches the body's side
      const double n = length_over_radius;
      const double arc = 0.5 * (n * n + 1.0);
      return std::sqrt(std::max(0.0, arc * arc - n * n * (1.0 - x) * (1.0 - x))) + 1.0 - arc;
    }
    case Geometry::NoseShape::ellipsoid: return std::sqrt(std::max(0.0, 1.0 - (1.0 - x) * (1.0 - x)));
    case Geometry::NoseShape::parabola: return 2.0 * x - x * x;
    case Geometry::NoseShape::haack: {  // least drag for length and diameter: von Karman's
      const double theta = std::acos(std::clamp(1.0 - 2.0 * x, -1.0, 1.0));
      return std::sqrt(std::max(0.0, (theta - 0.5 * std::sin(2.0 * theta)) / pi));
    }
  }
  return 1.0;
}

/// Integrals over the body's length, of slices thin enough for a part in a million.
struct Slices {
  double side_area_m2 = 0.0;
  double side_moment_m3 = 0.0;
  double volume_m3 = 0.0;
};

Slices slices(const Geometry& shape, double from_m, double to_m) {
  constexpr int count = 20000;
  Slices sum;
  const double step_m = (to_m - from_m) / count;
  for (int i = 0; i < count; ++i) {
    const double x_m = from_m + (static_cast<double>(i) + 0.5) * step_m;
    const double r_m = radius_m(shape, x_m);
    sum.side_area_m2 += 2.0 * r_m * step_m;
    sum.side_moment_m3 += 2.0 * r_m * x_m * step_m;
    sum.volume_m3 += pi * r_m * r_m * step_m;
  }
  return sum;
}

/// Twice the change of cross-section acts where a body of the same ends and volume has it: at its end, less the volume
/// over the change beyond the cylinder of its front.
double position_m(double end_m, double length_m, double volume_m3, double front_m2, double back_m2) {
  return end_m - (volume_m3 - front_m2 * length_m) / (back_m2 - front_m2);
}

}  // namespace

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

double radius_m(const Geometry& shape, double position_m) {
  const double radius_m = 0.5 * shape.diameter_m;
  if (position_m < shape.nose_length_m) {
    return radius_m * nose_profile(shape.nose_shape, position_m / shape.nose_length_m, shape.nose_length_m / radius_m);
  }
  double here_m = radius_m;
  for (const Geometry::Transition& transition : shape.transitions) {
    if (position_m <= transition.position_m) {
      break;
    }
    const double aft_m = 0.5 * transition.aft_diameter_m;
    const double along = (position_m - transition.position_m) / transition.length_m;
    if (along < 1.0) {
      return here_m + along * (aft_m - here_m);
    }
    here_m = aft_m;
  }
  return here_m;
}

double largest_diameter_m(const Geometry& shape) {
  double largest_m = shape.diameter_m;
  for (const Geometry::Transition& transition : shape.transitions) {
    largest_m = std::max(largest_m, transition.aft_diameter_m);
  }
  return largest_m;
}

BodyForces body_forces(const Geometry& shape) {
  const double front_m2 = 0.25 * pi * shape.diameter_m * shape.diameter_m;
  BodyForces forces;
  const Slices nose = slices(shape, 0.0, shape.nose_length_m);
  forces.nose_slope_area_m2 = 2.0 * front_m2;
  forces.nose_position_m = position_m(shape.nose_length_m, shape.nose_length_m, nose.volume_m3, 0.0, front_m2);
  double ahead_m2 = front_m2;
  for (const auto& [begin_m, length_m, aft_diameter_m] : shape.transitions) {
    const double back_m2 = 0.25 * pi * aft_diameter_m * aft_diameter_m;
    if (back_m2 != ahead_m2) {
      const double volume_m3 = slices(shape, begin_m, begin_m + length_m).volume_m3;
      forces.transitions.push_back(
          {.slope_area_m2 = 2.0 * (back_m2 - ahead_m2),
           .position_m = position_m(begin_m + length_m, length_m, volume_m3, ahead_m2, back_m2)});
    }
    ahead_m2 = back_m2;
  }
  const Slices whole = slices(shape, 0.0, shape.length_m);
  forces.side_area_m2 = whole.side_area_m2;
  forces.side_area_position_m = whole.side_moment_m3 / whole.side_area_m2;
  return forces;
}

}  // namespace fantail::airframe::model
