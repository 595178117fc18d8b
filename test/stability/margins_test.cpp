// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/roll_plant.hpp"
#include "stability/roll_loop.hpp"
#include "text/degrees.hpp"

namespace fantail::stability {
namespace {

using text::degrees;

// The first launch at its top speed, as published: alpha 7.5, beta 10, gains 1 and 0.1 s, in air of 1.2 kg/m3.
RollLoop launch1_at_97_m_s(double servo_lag_s, double delay_s) {
  const sim::RollPlant plant{
      .inertia_kg_m2 = 0.00361, .reference_area_m2 = 5.0265e-5, .damping_m2 = 7.5, .torque_m = 10};
  return {.proportional_gain = 1.0,
          .derivative_gain_s = 0.1,
          .damping_rate_per_s = plant.damping_rate_per_s(1.2, 97.0),
          .authority_per_s2 = plant.authority_per_s2(1.2, 97.0),
          .servo_lag_s = servo_lag_s,
          .delay_s = delay_s};
}

TEST(Oracle, Row29PhaseMarginsOfTheFirstLaunch) {
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.0, 0.0))->phase_margin_rad), 88, 3);
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.020, 0.0))->phase_margin_rad), 40, 3);
  EXPECT_NEAR(degrees(margins(launch1_at_97_m_s(0.020, 0.015))->phase_margin_rad), -7, 3);
}

// Rate feedback alone around a plant without damping is an integrator: |L| = kd b / w, its phase -90 degrees - delay w.
TEST(Margins, OfAnIntegratorWithDelayAreThoseOfTheTextbook) {
  const RollLoop loop{.derivative_gain_s = 0.1, .authority_per_s2 = 300.0, .delay_s = 0.01};
  const auto found = margins(loop);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->crossover_rad_s, 30.0, 1e-9);
  EXPECT_NEAR(found->phase_margin_rad, 0.5 * std::numbers::pi - 0.3, 1e-9);
  ASSERT_TRUE(found->gain_margin);
  EXPECT_NEAR(*found->gain_margin, 0.5 * std::numbers::pi / 0.01 / 30.0, 1e-9);
}

// K / (s (s + a) (1 + lag s)): Routh's rule gives the largest K as a (1 + a lag) / lag.
TEST(Margins, GainMarginWithoutRateFeedbackAgreesWithRouth) {
  const RollLoop loop{
      .proportional_gain = 0.5, .damping_rate_per_s = 8.0, .authority_per_s2 = 100.0, .servo_lag_s = 0.02};
  EXPECT_NEAR(*margins(loop)->gain_margin, 8.0 * (1.0 + 8.0 * 0.02) / 0.02 / 50.0, 1e-9);
}

TEST(Margins, AtTheGainMarginThePhaseMarginIsNought) {
  RollLoop loop = launch1_at_97_m_s(0.020, 0.005);
  const double factor = *margins(loop)->gain_margin;
  EXPECT_GT(factor, 1.0);
  loop.proportional_gain *= factor;
  loop.derivative_gain_s *= factor;
  EXPECT_NEAR(margins(loop)->phase_margin_rad, 0.0, 1e-9);
  EXPECT_NEAR(*margins(loop)->gain_margin, 1.0, 1e-9);
}

TEST(Margins, NoGainMakesALoopWithoutLagAndDelaySwing) {
  EXPECT_FALSE(margins(launch1_at_97_m_s(0.0, 0.0))->gain_margin);
}

TEST(Margins, ALoopWhoseGainNeverReachesOneHasNone) {
  EXPECT_FALSE(margins({.damping_rate_per_s = 5.0, .authority_per_s2 = 100.0, .servo_lag_s = 0.02}));
  EXPECT_FALSE(margins({.proportional_gain = 1.0, .damping_rate_per_s = 5.0, .authority_per_s2 = 0.0}));
  // kd b / (s + a) is largest at frequency zero.
  EXPECT_FALSE(margins({.derivative_gain_s = 0.01, .damping_rate_per_s = 5.0, .authority_per_s2 = 400.0}));
  EXPECT_TRUE(margins({.derivative_gain_s = 0.01, .damping_rate_per_s = 5.0, .authority_per_s2 = 600.0}));
}

}  // namespace
}  // namespace fantail::stability
