// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "tune/linear_trial.hpp"

namespace fantail::tune {
namespace {

// s^2 + (a + b kd) s + b kp with two equal poles at -w: 1 - (1 + w t) e^(-w t), within a tenth from w t = 3.8897 on.
TEST(LinearStep, OfALoopWithTwoEqualPolesIsTheTextbooks) {
  constexpr double w = 5.0;
  const stability::RollLoop loop{.proportional_gain = w * w / 100.0,
                                 .derivative_gain_s = (2.0 * w - 4.0) / 100.0,
                                 .damping_rate_per_s = 4.0,
                                 .authority_per_s2 = 100.0};
  const std::vector<double> angles = step_response(loop, 2.0);
  for (const std::size_t i : {99U, 499U, 999U}) {
    const double t = 1e-3 * static_cast<double>(i + 1);
    EXPECT_NEAR(angles[i], 1.0 - (1.0 + w * t) * std::exp(-w * t), 2e-3) << t;
  }
  EXPECT_NEAR(settling_s(loop, 2.0).value(), 3.8897 / w, 2e-3);
  EXPECT_FALSE(settling_s(loop, 0.5));
}

// An integral that is slow beside the loop: its pole is near -ki / kp.
TEST(LinearStep, IntegralActionComesBackFromItsOvershootWithItsOwnTime) {
  stability::RollLoop loop{.proportional_gain = 0.5,
                           .derivative_gain_s = 0.1,
                           .integral_gain_per_s = 0.1,
                           .damping_rate_per_s = 5.0,
                           .authority_per_s2 = 500.0};
  const std::vector<double> angles = step_response(loop, 10.0);
  EXPECT_GT(angles[1999], 1.0);
  EXPECT_NEAR((angles[6999] - 1.0) / (angles[1999] - 1.0), std::exp(-0.2 * 5.0), 0.05);
}

TEST(LinearStep, ALoopThatSwingsNeverSettles) {
  const stability::RollLoop loop{.proportional_gain = 5.0,
                                 .derivative_gain_s = 0.02,
                                 .damping_rate_per_s = 3.0,
                                 .authority_per_s2 = 500.0,
                                 .servo_lag_s = 0.02,
                                 .delay_s = 0.005};
  ASSERT_LT(*stability::phase_margin_rad(loop), 0.0);
  EXPECT_FALSE(settling_s(loop, 5.0));
}

}  // namespace
}  // namespace fantail::tune
