// SPDX-License-Identifier: MIT
#include "sim/roll_plant.hpp"

#include "degree.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double density_kg_m3 = 1.2;
constexpr RollPlant tunnel_rocket{
    .inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5, .damping_m2 = 19.4, .torque_m = 9.6};

// The same solution from the textbook's formulas, in long double: what cancels here is 2000 times smaller.
struct Exact {
  long double angle;
  long double rate;
};
Exact analytic(const RollPlant& plant, const RollState& from, long double speed, long double deflection,
               long double dt) {
  const auto damping = static_cast<long double>(plant.damping_m2);
  const long double a = 0.5L * static_cast<long double>(density_kg_m3) * speed *
                        static_cast<long double>(plant.reference_area_m2) * damping /
                        static_cast<long double>(plant.inertia_kg_m2);
  const long double final_rate = speed * static_cast<long double>(plant.torque_m) / damping * deflection;
  const long double deviation = static_cast<long double>(from.rate_rad_s) - final_rate;
  return {.angle = static_cast<long double>(from.angle_rad) + final_rate * dt - deviation * std::expm1(-a * dt) / a,
          .rate = final_rate + deviation * std::exp(-a * dt)};
}

TEST(RollPlant, SteadyRateDoesNotDependOnTheReferenceArea) {
  for (const double area_m2 : {5.0265e-5, 4.6e-5, 5.03e-3}) {
    RollPlant plant = tunnel_rocket;
    plant.reference_area_m2 = area_m2;
    RollState state{};
    for (int i = 0; i < 30000; ++i) {
      state = plant.step(state, density_kg_m3, 22.0, 1.0 * degree, 0.001);
    }
    EXPECT_NEAR(state.rate_rad_s / degree, 10.887, 10.887 * 0.001) << area_m2;
  }
}

TEST(RollPlant, TimeConstantsAreThoseOfTheTunnelAndOfTheFlight) {
  const std::pair<double, double> speeds_and_times[]{{22.0, 0.30531}, {30.0, 0.22390}, {97.0, 0.06925}};
  for (const auto& [speed_m_s, time_constant_s] : speeds_and_times) {
    EXPECT_NEAR(1.0 / tunnel_rocket.damping_rate_per_s(density_kg_m3, speed_m_s), time_constant_s, 1e-4);
    const RollState after = tunnel_rocket.step({0.0, 1.0}, density_kg_m3, speed_m_s, 0.0, time_constant_s);
    EXPECT_NEAR(after.rate_rad_s, std::exp(-1.0), 1e-4);
  }
}

TEST(RollPlant, TheEquivalentFinOffsetOfASteadyRateHoldsThatRate) {
  const double rate_rad_s = -66.0 * degree;
  const double offset_rad = -6.0625 * degree;
  const double balance = tunnel_rocket.damping_rate_per_s(density_kg_m3, 22.0) * rate_rad_s /
                         tunnel_rocket.authority_per_s2(density_kg_m3, 22.0);
  EXPECT_NEAR(balance / degree, offset_rad / degree, 1e-4);
  const RollState after = tunnel_rocket.step({0.0, rate_rad_s}, density_kg_m3, 22.0, offset_rad, 10.0);
  EXPECT_NEAR(after.rate_rad_s / degree, -66.0, 1e-3);
}

TEST(RollPlant, PositiveDeflectionGivesPositiveMomentAndPositiveRoll) {
  const RollState after = tunnel_rocket.step({}, density_kg_m3, 22.0, 1.0 * degree, 0.01);
  EXPECT_GT(after.rate_rad_s, 0.0);
  EXPECT_GT(after.angle_rad, 0.0);
}

TEST(RollPlant, OneStepIsTheAnalyticExponentialAtEveryStepLength) {
  const RollState start{.angle_rad = 0.3, .rate_rad_s = -1.7};
  for (const double speed_m_s : {0.01, 1.0, 22.0, 97.0, 400.0}) {
    for (const double dt_s : {1e-6, 1e-4, 1e-3, 0.004, 0.019, 0.0191, 0.02, 0.3, 5.0, 100.0}) {
      const RollState step = tunnel_rocket.step(start, density_kg_m3, speed_m_s, 2.0 * degree, dt_s);
      const Exact exact = analytic(tunnel_rocket, start, static_cast<long double>(speed_m_s),
                                   static_cast<long double>(2.0 * degree), static_cast<long double>(dt_s));
      EXPECT_NEAR(step.rate_rad_s, static_cast<double>(exact.rate), 4e-15 * (1.0 + std::abs(step.rate_rad_s)))
          << speed_m_s << " " << dt_s;
      EXPECT_NEAR(step.angle_rad, static_cast<double>(exact.angle), 4e-15 * (1.0 + std::abs(step.angle_rad)))
          << speed_m_s << " " << dt_s;
    }
  }
}

// The part of the angle that the torque makes is dt^2 / 2 times the acceleration: all its digits must be there when the
// damping of one step is too small to see.
TEST(RollPlant, NothingCancelsWhenTheDampingOfOneStepIsTiny) {
  for (const double rate_per_s : {0.0, 1e-300, 1e-12, 1e-6, 1e-3, 1.0, 62.4, 62.6, 500.0, 999.0, 1001.0, 3e3}) {
    const double dt_s = 0.001;
    const RollTransition transition = roll_transition(rate_per_s, dt_s);
    const long double x = static_cast<long double>(rate_per_s) * static_cast<long double>(dt_s);
    // 1/2 - x/6 + x^2/24 ... summed to the end: a series of its own length, in long double.
    long double term = 0.5L;
    long double sum = 0.0L;
    for (int k = 3; k < 200; ++k) {
      sum += term;
      term *= -x / k;
    }
    EXPECT_NEAR(transition.c2_s2 / (dt_s * dt_s), static_cast<double>(sum), 1e-14 * static_cast<double>(sum)) << x;
    EXPECT_NEAR(transition.c1_s / dt_s, static_cast<double>(1.0L - x * sum), 4e-16) << x;
    EXPECT_NEAR(transition.decay, static_cast<double>(std::exp(-x)), 4e-16) << x;
  }
}

TEST(RollPlant, TwoHalfStepsAreOneWholeStep) {
  std::mt19937_64 random{test::seed(20160703)};
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int i = 0; i < 2000; ++i) {
    RollPlant plant = tunnel_rocket;
    plant.reference_area_m2 *= std::exp(between(-5.0, 5.0));
    const RollState start{.angle_rad = between(-10.0, 10.0), .rate_rad_s = between(-5.0, 5.0)};
    const double speed_m_s = between(0.0, 150.0);
    const double deflection_rad = between(-0.2, 0.2);
    const double dt_s = std::exp(between(-8.0, 0.0));
    const RollState whole = plant.step(start, density_kg_m3, speed_m_s, deflection_rad, dt_s);
    const RollState half = plant.step(start, density_kg_m3, speed_m_s, deflection_rad, 0.5 * dt_s);
    const RollState twice = plant.step(half, density_kg_m3, speed_m_s, deflection_rad, 0.5 * dt_s);
    ASSERT_NEAR(twice.rate_rad_s, whole.rate_rad_s, 1e-13 * (1.0 + std::abs(whole.rate_rad_s)));
    ASSERT_NEAR(twice.angle_rad, whole.angle_rad, 1e-13 * (1.0 + std::abs(whole.angle_rad)));
  }
}

TEST(RollPlant, DecaysWithTheGeometricAreaWhereARungeKuttaStepDiverges) {
  RollPlant stiff = tunnel_rocket;
  stiff.reference_area_m2 = std::numbers::pi * 0.04 * 0.04;
  stiff.damping_m2 = 60.0;
  // Classical Runge-Kutta is stable up to 2.79 time constants a step; this is far beyond.
  ASSERT_GT(stiff.damping_rate_per_s(density_kg_m3, 97.0) * 0.001, 2.79);
  RollState state{.angle_rad = 0.0, .rate_rad_s = 10.0};
  double previous = state.rate_rad_s;
  for (int i = 0; i < 200; ++i) {
    state = stiff.step(state, density_kg_m3, 97.0, 0.0, 0.001);
    ASSERT_GE(state.rate_rad_s, 0.0);
    ASSERT_LE(state.rate_rad_s, previous);
    previous = state.rate_rad_s;
  }
  EXPECT_LT(state.rate_rad_s, 1e-100);
  EXPECT_NEAR(state.angle_rad, 10.0 / stiff.damping_rate_per_s(density_kg_m3, 97.0), 1e-12);
}

TEST(RollPlant, SettlesAtOnceWhenInfinitelyStiffAndDriftsFreelyInStillAir) {
  const RollTransition rigid = roll_transition(1e12, 0.001);
  EXPECT_EQ(rigid.decay, 0.0);
  EXPECT_NEAR(rigid.c1_s * 1e12, 1.0, 1e-15);
  const RollState drift = tunnel_rocket.step({1.0, 2.0}, density_kg_m3, 0.0, 0.1, 0.25);
  EXPECT_DOUBLE_EQ(drift.rate_rad_s, 2.0);
  EXPECT_DOUBLE_EQ(drift.angle_rad, 1.5);
}

TEST(RollPlant, AirFromBehindStillDampsTheRate) {
  const RollState after = tunnel_rocket.step({0.0, 1.0}, density_kg_m3, -22.0, 0.0, 1.0);
  EXPECT_NEAR(after.rate_rad_s, std::exp(-1.0 / 0.30531), 1e-4);
}

}  // namespace
}  // namespace fantail::sim
