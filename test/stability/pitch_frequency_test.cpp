// SPDX-License-Identifier: MIT
#include "stability/pitch_frequency.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fantail::stability {
namespace {

// Of a small swing: I q'' = -1/2 rho v^2 A C (x_cp - x_cg) q, whose frequency over v is a number of the rocket and the
// air.
TEST(PitchFrequency, IsThatOfASmallSwingOverTheAirSpeed) {
  sim::Airframe airframe;
  airframe.diameter_m = 0.1;
  airframe.normal_force_slope_per_rad = 10.0;
  airframe.centre_of_pressure_m = 1.2;
  airframe.at_liftoff.centre_of_gravity_m = 1.0;
  airframe.at_liftoff.transverse_inertia_kg_m2 = 0.5;
  airframe.after_burnout.centre_of_gravity_m = 0.9;
  airframe.after_burnout.transverse_inertia_kg_m2 = 0.4;
  const double area_m2 = std::numbers::pi * 0.05 * 0.05;
  const auto found = pitch_frequency(airframe, 1.2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->least_1_m, std::sqrt(0.6 * area_m2 * 10.0 * 0.2 / 0.5), 1e-12);
  EXPECT_NEAR(found->most_1_m, std::sqrt(0.6 * area_m2 * 10.0 * 0.3 / 0.4), 1e-12);
  airframe.at_liftoff.centre_of_gravity_m = 1.2;
  EXPECT_FALSE(pitch_frequency(airframe, 1.2)) << "it does not swing back";
}

}  // namespace
}  // namespace fantail::stability
