// SPDX-License-Identifier: MIT
#include "airframe/model/fin_set.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fantail::airframe::model {
namespace {

constexpr double pi = std::numbers::pi;

sim::Geometry::FinSet rectangle(double span_m, double chord_m) {
  return {.count = 4, .position_m = 1.0, .root_chord_m = chord_m, .tip_chord_m = chord_m, .span_m = span_m};
}

TEST(FinForces, OfALongThinWingAreThoseOfThinAirfoilTheory) {
  const FinForces forces = fin_forces(rectangle(100.0, 0.1), 0.01);
  EXPECT_NEAR(forces.one_fin_area_m2 / (100.0 * 0.1), 2.0 * pi, 0.01);
}

TEST(FinForces, OfASlenderFinAreThoseOfSlenderWingTheory) {
  const FinForces forces = fin_forces(rectangle(0.001, 1.0), 10.0);
  EXPECT_NEAR(forces.one_fin_area_m2 / (0.001 * 0.001), pi, 1e-4);
}

TEST(FinForces, OfARectangleActAtAQuarterOfItsChordAndHalfItsSpan) {
  const FinForces forces = fin_forces(rectangle(0.06, 0.1), 0.04);
  EXPECT_NEAR(forces.position_m, 1.0 + 0.025, 1e-12);
  EXPECT_NEAR(forces.arm_m, 0.04 + 0.03, 1e-12);
  EXPECT_NEAR(forces.mean_chord_m, 0.1, 1e-12);
}

TEST(FinForces, OfASweptTriangleActAtAQuarterOfItsMeanChord) {
  const sim::Geometry::FinSet triangle{
      .count = 3, .position_m = 2.0, .root_chord_m = 0.3, .tip_chord_m = 0.0, .span_m = 0.1, .sweep_m = 0.3};
  const FinForces forces = fin_forces(triangle, 0.05);
  EXPECT_NEAR(forces.mean_chord_m, 0.2, 1e-12);                   // two thirds of the root's
  EXPECT_NEAR(forces.position_m, 2.0 + 0.1 + 0.25 * 0.2, 1e-12);  // at a third of the span
  EXPECT_NEAR(forces.arm_m, 0.05 + 0.1 / 3.0, 1e-12);
}

// NACA report 1307 gives the slender-body factor k_W(B) of turned fins as a table over body radius by tip radius.
TEST(FinForces, OfTurnedFinsLoseWhatSlenderBodyTheorySays) {
  struct Row {
    double radius_by_tip;
    double factor;
  };
  for (const Row& row : {Row{0.2, 0.944}, Row{0.4, 0.936}, Row{0.6, 0.949}}) {
    const double radius_m = 0.05;
    const FinForces forces = fin_forces(rectangle(radius_m / row.radius_by_tip - radius_m, 0.1), radius_m);
    EXPECT_NEAR(forces.roll_torque_m3 / (4.0 * forces.one_fin_area_m2 * forces.arm_m), row.factor, 0.003)
        << row.radius_by_tip;
  }
}

// Without a body every strip of a rolling fin has an angle of its own: the integral of chord times distance squared.
TEST(FinForces, OfRollingFinsOnAThinBodyAreAnIntegralOverTheirStrips) {
  const double span_m = 0.5;
  const double chord_m = 0.1;
  const FinForces forces = fin_forces(rectangle(span_m, chord_m), 1e-6);
  const double slope = forces.one_fin_area_m2 / (span_m * chord_m);
  EXPECT_NEAR(forces.roll_damping_m4 / (4.0 * slope * chord_m * span_m * span_m * span_m / 3.0), 1.0, 1e-3);
}

}  // namespace
}  // namespace fantail::airframe::model
