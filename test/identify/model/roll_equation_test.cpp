// SPDX-License-Identifier: MIT
#include "identify/model/roll_equation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fantail::identify::model {
namespace {

constexpr double alpha_m2 = 20.0;
constexpr double beta_m = 9.0;
const RollEquation equation = roll_equation({.inertia_kg_m2 = 0.004, .reference_area_m2 = 5e-5}, 1.2, 50.0);

struct Roll {
  double angle_rad;
  double rate_rad_s;
};

// dp/dt = - damping p + acceleration, by ten thousand midpoint steps, under a deflection that runs straight.
Roll integrated(Roll roll, double from_rad, double to_rad, double dt_s) {
  constexpr int steps = 10000;
  const double h = dt_s / steps;
  const auto slope = [&](double share, double rate_rad_s) {
    return equation.acceleration_rad_s2(beta_m, from_rad + share * (to_rad - from_rad)) -
           equation.damping_rate_per_s(alpha_m2) * rate_rad_s;
  };
  for (int i = 0; i < steps; ++i) {
    const double middle = roll.rate_rad_s + 0.5 * h * slope(static_cast<double>(i) / steps, roll.rate_rad_s);
    roll.angle_rad += h * middle;
    roll.rate_rad_s += h * slope((i + 0.5) / steps, middle);
  }
  return roll;
}

TEST(RollEquation, ItsCoefficientsAreThosePrinted) {
  EXPECT_DOUBLE_EQ(equation.damping_per_m2_s, 0.5 * 1.2 * 50.0 * 5e-5 / 0.004);
  EXPECT_DOUBLE_EQ(equation.authority_per_m_s2, 0.5 * 1.2 * 50.0 * 50.0 * 5e-5 / 0.004);
}

TEST(RollEquation, BothExactStepsSolveIt) {
  constexpr Roll before{.angle_rad = 0.3, .rate_rad_s = -0.5};
  constexpr double from_rad = 0.02;
  constexpr double to_rad = -0.05;
  for (const double dt_s : {0.001, 0.02, 0.5}) {
    SCOPED_TRACE(dt_s);
    const Roll straight = integrated(before, from_rad, to_rad, dt_s);
    const RampStep ramp = ramp_step(equation.damping_rate_per_s(alpha_m2), dt_s);
    const double g0 = equation.acceleration_rad_s2(beta_m, from_rad);
    const double g1 = equation.acceleration_rad_s2(beta_m, to_rad);
    EXPECT_NEAR(before.angle_rad + ramp.angle_change(before.rate_rad_s, g0, g1), straight.angle_rad, 1e-8);
    EXPECT_NEAR(ramp.rate_after(before.rate_rad_s, g0, g1), straight.rate_rad_s, 1e-8);
    const Roll flat = integrated(before, from_rad, from_rad, dt_s);
    const HeldStep held = held_step(equation, alpha_m2, dt_s);
    EXPECT_NEAR(before.angle_rad + held.angle_change(before.rate_rad_s, beta_m * from_rad), flat.angle_rad, 1e-8);
    EXPECT_NEAR(held.rate_after(before.rate_rad_s, beta_m * from_rad), flat.rate_rad_s, 1e-8);
  }
}

TEST(HeldStep, ItsSlopeIsThatOfDifferences) {
  constexpr double change_m2 = 1e-3;
  for (const double dt_s : {0.0, 0.001, 0.1}) {
    SCOPED_TRACE(dt_s);
    const HeldStep more = held_step(equation, alpha_m2 + change_m2, dt_s);
    const HeldStep less = held_step(equation, alpha_m2 - change_m2, dt_s);
    const auto [step, by_alpha] = held_step_and_slope(equation, alpha_m2, dt_s);
    for (double HeldStep::* const number :
         {&HeldStep::decay, &HeldStep::angle_p_s, &HeldStep::rate_gain, &HeldStep::angle_gain}) {
      EXPECT_EQ(step.*number, held_step(equation, alpha_m2, dt_s).*number);
      EXPECT_NEAR(by_alpha.*number, (more.*number - less.*number) / (2.0 * change_m2), 1e-9);
    }
  }
}

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
  constexpr long double exact_dt = 0.5L;
  for (const double x : {1e-12, 1e-6, 1e-3, 0.1, 0.2499999, 0.25, 1.0, 5.0, 40.0}) {
    // Textbook integrals in extended precision; they cancel for small x, so the bound is loose there.
    const long double a = static_cast<long double>(x) / exact_dt;
    const long double e = std::exp(-static_cast<long double>(x));
    const long double c1 = (1.0L - e) / a;
    const long double c2 = (exact_dt - c1) / a;
    const long double c3 = (0.5L * exact_dt * exact_dt - c2) / a;
    const RampStep t = ramp_step(x / dt, dt);
    const double bound = 1e-13 + 1e-18 / (x * x * x);
    if (bound > 1e-3) {
      continue;
    }
    SCOPED_TRACE(x);
    EXPECT_NEAR(t.decay, static_cast<double>(e), bound);
    EXPECT_NEAR(t.rate_0, static_cast<double>(c1 - c2 / exact_dt), bound);
    EXPECT_NEAR(t.rate_1, static_cast<double>(c2 / exact_dt), bound);
    EXPECT_NEAR(t.angle_p, static_cast<double>(c1), bound);
    EXPECT_NEAR(t.angle_0, static_cast<double>(c2 - c3 / exact_dt), bound);
    EXPECT_NEAR(t.angle_1, static_cast<double>(c3 / exact_dt), bound);
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
