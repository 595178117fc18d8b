// SPDX-License-Identifier: MIT
#include "airframe/model/body.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fantail::airframe::model {
namespace {

using Nose = sim::Geometry::NoseShape;

sim::Geometry rocket(Nose nose) {
  return {.nose_shape = nose, .nose_length_m = 0.3, .diameter_m = 0.1, .length_m = 1.3};
}

TEST(BodyForces, OfANoseAreTwiceItsCrossSectionWhateverItsShape) {
  for (const Nose nose : {Nose::cone, Nose::ogive, Nose::ellipsoid, Nose::parabola, Nose::haack}) {
    EXPECT_NEAR(body_forces(rocket(nose)).nose_slope_area_m2, 2.0 * 0.25 * std::numbers::pi * 0.01, 1e-12);
  }
}

TEST(BodyForces, OfANoseActWhereItsVolumeSays) {
  EXPECT_NEAR(body_forces(rocket(Nose::cone)).nose_position_m, 0.3 * 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(body_forces(rocket(Nose::ellipsoid)).nose_position_m, 0.3 / 3.0, 1e-6);
  EXPECT_NEAR(body_forces(rocket(Nose::parabola)).nose_position_m, 0.3 * (1.0 - 8.0 / 15.0), 1e-6);
  EXPECT_NEAR(body_forces(rocket(Nose::haack)).nose_position_m, 0.3 * 0.5, 1e-6);
  sim::Geometry slender = rocket(Nose::ogive);  // the longer, the more like a parabola
  slender.nose_length_m = 1.3;
  EXPECT_NEAR(body_forces(slender).nose_position_m / 1.3, 7.0 / 15.0, 1e-3);
}

TEST(BodyForces, OfAnOgiveAsLongAsWideIsAHalfSphere) {
  sim::Geometry ball = rocket(Nose::ogive);
  ball.nose_length_m = 0.05;
  EXPECT_NEAR(body_forces(ball).nose_position_m, 0.05 / 3.0, 1e-6);
}

// Barrowman's own formula for a conical transition, d1 to d2, L long: L / 3 (1 + (1 - d1/d2) / (1 - (d1/d2)^2)).
TEST(BodyForces, OfATransitionFollowBarrowmansFormula) {
  for (const double aft_m : {0.15, 0.06}) {
    sim::Geometry shape = rocket(Nose::cone);
    shape.transitions = {{.position_m = 0.7, .length_m = 0.2, .aft_diameter_m = aft_m}};
    const BodyForces forces = body_forces(shape);
    const double ratio = 0.1 / aft_m;
    EXPECT_NEAR(forces.transitions.at(0).position_m, 0.7 + 0.2 / 3.0 * (1.0 + (1.0 - ratio) / (1.0 - ratio * ratio)),
                1e-5);
    EXPECT_NEAR(forces.transitions.at(0).slope_area_m2, 0.5 * std::numbers::pi * (aft_m * aft_m - 0.01), 1e-12);
  }
}

TEST(BodyForces, FromTheSideAreATriangleAndARectangleWithACone) {
  const BodyForces forces = body_forces(rocket(Nose::cone));
  const double nose_m2 = 0.5 * 0.3 * 0.1;
  const double tube_m2 = 1.0 * 0.1;
  EXPECT_NEAR(forces.side_area_m2, nose_m2 + tube_m2, 1e-6);
  EXPECT_NEAR(forces.side_area_position_m, (nose_m2 * 0.2 + tube_m2 * 0.8) / (nose_m2 + tube_m2), 1e-5);
}

}  // namespace
}  // namespace fantail::airframe::model
