// SPDX-License-Identifier: MIT
#include "sim/thrust_curve.hpp"

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fantail::sim {
namespace {

// Two triangles and a plateau: every figure can be done in the head.
ThrustCurve plateau() { return {{{0.0, 0.0}, {1.0, 100.0}, {3.0, 100.0}, {3.5, 0.0}}, 0.2}; }

TEST(ThrustCurve, ImpulseIsTheAreaUnderTheLines) {
  EXPECT_DOUBLE_EQ(plateau().impulse_n_s(), 50.0 + 200.0 + 25.0);
  EXPECT_DOUBLE_EQ(plateau().propellant_kg(), 0.2);
  EXPECT_DOUBLE_EQ(plateau().burnout_s(), 3.5);
}

TEST(ThrustCurve, ThrustRunsStraightBetweenPointsAndIsZeroOutside) {
  const ThrustCurve motor = plateau();
  EXPECT_EQ(motor.thrust_n(-0.1), 0.0);
  EXPECT_EQ(motor.thrust_n(0.0), 0.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(0.25), 25.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(1.0), 100.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(2.9), 100.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(3.25), 50.0);
  EXPECT_EQ(motor.thrust_n(3.5), 0.0);
  EXPECT_EQ(motor.thrust_n(100.0), 0.0);
}

TEST(ThrustCurve, ImpulseSoFarIsTheExactIntegral) {
  const ThrustCurve motor = plateau();
  EXPECT_EQ(motor.impulse_until(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(0.5), 12.5);  // 1/2 100 t^2
  EXPECT_DOUBLE_EQ(motor.impulse_until(1.0), 50.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(2.5), 200.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(3.25), 250.0 + 18.75);
  EXPECT_DOUBLE_EQ(motor.impulse_until(3.5), 275.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(9.0), 275.0);
}

TEST(ThrustCurve, MayStartAtFullThrust) {
  const ThrustCurve motor{{{0.0, 40.0}, {2.0, 40.0}, {2.001, 0.0}}, 0.1};
  EXPECT_EQ(motor.thrust_n(-1e-9), 0.0);
  EXPECT_EQ(motor.thrust_n(0.0), 40.0);
}

TEST(ThrustCurve, NoMotorGivesNothing) {
  const ThrustCurve none;
  EXPECT_EQ(none.thrust_n(0.0), 0.0);
  EXPECT_EQ(none.impulse_until(5.0), 0.0);
  EXPECT_EQ(none.impulse_n_s(), 0.0);
}

TEST(ThrustCurve, RefusesPointsThatCannotBeAMotor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<ThrustPoint>> impossible{
      {},
      {{0.0, 0.0}},
      {{0.0, 10.0}, {1.0, 10.0}, {0.5, 0.0}},  // back in time
      {{0.0, 10.0}, {1.0, 10.0}, {1.0, 0.0}},  // two thrusts at once
      {{-0.1, 10.0}, {1.0, 0.0}},
      {{0.0, 10.0}, {1.0, -5.0}, {2.0, 0.0}},
      {{0.0, 10.0}, {nan, 5.0}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, nan}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, infinity}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, 5.0}},  // never ends
      {{0.0, 0.0}, {1.0, 0.0}},   // never burns
      {{0.0, 1e308}, {1e10, 1e308}, {2e10, 0.0}},
  };
  for (std::size_t i = 0; i < impossible.size(); ++i) {
    EXPECT_THROW((ThrustCurve{impossible[i], 0.1}), std::invalid_argument) << "case " << i;
  }
  for (const double propellant_kg : {0.0, -0.1, nan, infinity}) {
    EXPECT_THROW((ThrustCurve{{{0.0, 10.0}, {1.0, 0.0}}, propellant_kg}), std::invalid_argument) << propellant_kg;
  }
}

}  // namespace
}  // namespace fantail::sim
