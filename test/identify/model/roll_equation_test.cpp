// SPDX-License-Identifier: MIT
#include "identify/model/roll_equation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fantail::identify::model {
namespace {

TEST(RampStep, WithoutDampingItIsTheIntegralOfARamp) {
  const RampStep t = ramp_step(0.0, 0.01);
  EXPECT_DOUBLE_EQ(t.decay, 1.0);
  EXPECT_DOUBLE_EQ(t.rate_0, 0.005);
  EXPECT_DOUBLE_EQ(t.rate_1, 0.005);
  EXPECT_DOUBLE_EQ(t.angle_p, 0.01);
  EXPECT_DOUBLE_EQ(t.angle_0, 1e-4 / 3.0);
  EXPECT_DOUBLE_EQ(t.angle_1, 1e-4 / 6.0);
}

TEST(RampStep, ItIsTheClosedFormForEveryDamping) {
  constexpr double dt = 0.5;
  for (const double x : {1e-12, 1e-6, 1e-3, 0.1, 0.2499999, 0.25, 1.0, 5.0, 40.0}) {
    // Textbook integrals in extended precision; they cancel for small x, so the bound is loose there.
    const long double a = static_cast<long double>(x) / dt;
    const long double e = std::exp(-static_cast<long double>(x));
    const long double c1 = (1.0L - e) / a;
    const long double c2 = (dt - c1) / a;
    const long double c3 = (0.5L * dt * dt - c2) / a;
    const RampStep t = ramp_step(x / dt, dt);
    const double bound = 1e-13 + 1e-18 / (x * x * x);
    if (bound > 1e-3) {
      continue;
    }
    SCOPED_TRACE(x);
    EXPECT_NEAR(t.decay, static_cast<double>(e), bound);
    EXPECT_NEAR(t.rate_0, static_cast<double>(c1 - c2 / dt), bound);
    EXPECT_NEAR(t.rate_1, static_cast<double>(c2 / dt), bound);
    EXPECT_NEAR(t.angle_p, static_cast<double>(c1), bound);
    EXPECT_NEAR(t.angle_0, static_cast<double>(c2 - c3 / dt), bound);
    EXPECT_NEAR(t.angle_1, static_cast<double>(c3 / dt), bound);
  }
}

TEST(RampStep, TwoHalfStepsAreOneWholeStep) {
  for (const double a : {0.0, 0.3, 3.0, 30.0}) {
    const RampStep whole = ramp_step(a, 0.2);
    const RampStep half = ramp_step(a, 0.1);
    const double g0 = 2.0;
    const double g1 = -1.0;
    const double middle = 0.5 * (g0 + g1);
    double angle = 0.4;
    double rate = 1.5;
    const double whole_angle = angle + whole.angle_p * rate + whole.angle_0 * g0 + whole.angle_1 * g1;
    const double whole_rate = whole.decay * rate + whole.rate_0 * g0 + whole.rate_1 * g1;
    angle += half.angle_p * rate + half.angle_0 * g0 + half.angle_1 * middle;
    rate = half.decay * rate + half.rate_0 * g0 + half.rate_1 * middle;
    angle += half.angle_p * rate + half.angle_0 * middle + half.angle_1 * g1;
    rate = half.decay * rate + half.rate_0 * middle + half.rate_1 * g1;
    EXPECT_NEAR(angle, whole_angle, 1e-14);
    EXPECT_NEAR(rate, whole_rate, 1e-14);
  }
}

}  // namespace
}  // namespace fantail::identify::model
