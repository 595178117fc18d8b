// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "paper/recomputed.hpp"

namespace fantail::paper {
namespace {

constexpr double g = 9.80665;

// By steps of 10 us: the speed is held until what is left is what a coast needs, found by trying.
double stepped_time_s(double height_m, double speed_m_s, double drag_per_mass_1_m) {
  constexpr double dt = 1e-5;
  double coast_m = 0.0;
  double coast_s = 0.0;
  for (double v = speed_m_s; v > 0.0; v -= (g + drag_per_mass_1_m * v * v) * dt) {
    coast_m += v * dt;
    coast_s += dt;
  }
  return coast_s + (height_m - coast_m) / speed_m_s;
}

TEST(FastestAscent, IsTheTimeThatSmallStepsGive) {
  EXPECT_NEAR(least_time_to_apogee_s(522, 97, {9.44e-4}), stepped_time_s(522, 97, 9.44e-4), 1e-3);
}

TEST(FastestAscent, WithoutDragItIsTheTextbookCoastBehindAClimbAtTopSpeed) {
  EXPECT_NEAR(least_time_to_apogee_s(522, 97, {1e-12}), 97 / (2 * g) + 522.0 / 97, 1e-4);
}

TEST(FastestAscent, ALowApogeeNeedsLessThanTheTopSpeed) {
  EXPECT_NEAR(least_time_to_apogee_s(20, 97, {1e-12}), std::sqrt(2 * 20 / g), 1e-4);
}

TEST(FastestAscent, MoreDragShortensIt) {
  EXPECT_LT(least_time_to_apogee_s(522, 97, {2e-3}), least_time_to_apogee_s(522, 97, {1e-3}));
}

}  // namespace
}  // namespace fantail::paper
