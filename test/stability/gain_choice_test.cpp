// SPDX-License-Identifier: MIT
#include "stability/gain_choice.hpp"

#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::stability {
namespace {

using text::radians;

constexpr Gains largest{.proportional = 10.0, .derivative_s = 2.0};

/// Slow air and much inertia: hardly any damping of its own.
RollLoop heavy_rocket() {
  return {.damping_rate_per_s = 0.1, .authority_per_s2 = 20.0, .servo_lag_s = 0.02, .delay_s = 0.005};
}

/// The first launch at 97 m/s.
RollLoop fast_rocket() {
  return {.damping_rate_per_s = 6.1, .authority_per_s2 = 786.0, .servo_lag_s = 0.02, .delay_s = 0.005};
}

double least_phase_margin(const LoopsAtSpeeds& loops, const Gains& gains) {
  double least = std::numbers::pi;
  for (const auto& at_speed : loops) {
    for (RollLoop loop : at_speed) {
      loop.proportional_gain = gains.proportional;
      loop.derivative_gain_s = gains.derivative_s;
      least = std::min(least, margins(loop)->phase_margin_rad);
    }
  }
  return least;
}

// (kp + kd s) b / (s (s + a)) with kd = kp / a is kp b / (a s) exactly: an integrator, whose phase margin with a delay
// is 90 degrees - delay kp b / a. So at kp b / a = 10 rad/s and 0.05 s of delay it is 61.35 degrees.
TEST(GainChoice, MeetsADemandUpToThePhaseMarginOfTheClosedForm) {
  const LoopsAtSpeeds loops{{{.damping_rate_per_s = 5.0, .authority_per_s2 = 50.0, .delay_s = 0.05}}};
  const Gains gains{.proportional = 1.0, .derivative_s = 0.2};
  const double closed_form_rad = 0.5 * std::numbers::pi - 0.5;
  EXPECT_TRUE(meets(loops, gains, {.phase_margin_rad = closed_form_rad - 1e-6}));
  EXPECT_FALSE(meets(loops, gains, {.phase_margin_rad = closed_form_rad + 1e-6}));
}

TEST(GainChoice, ALoopThatIsTooFastNeedsSmallerGains) {
  const LoopsAtSpeeds loops{{fast_rocket()}};
  const Gains present{.proportional = 1.0, .derivative_s = 0.1};
  EXPECT_LT(least_phase_margin(loops, present), radians(30.0));
  const auto found = nearest_gains(loops, present, largest, {.phase_margin_rad = radians(45.0)});
  ASSERT_TRUE(found);
  EXPECT_GE(least_phase_margin(loops, *found), radians(45.0));
  EXPECT_LT(found->derivative_s, present.derivative_s);
}

// The advice that used to be printed always, smaller gains, makes this one worse.
TEST(GainChoice, ALoopThatIsDampedTooLittleNeedsMoreRateFeedback) {
  const LoopsAtSpeeds loops{{heavy_rocket()}};
  const Gains present{.proportional = 0.5, .derivative_s = 0.05};
  EXPECT_LT(least_phase_margin(loops, present), radians(30.0));
  EXPECT_LT(least_phase_margin(loops, {0.25, 0.025}), least_phase_margin(loops, present));
  const auto found = nearest_gains(loops, present, largest, {.phase_margin_rad = radians(45.0)});
  ASSERT_TRUE(found);
  EXPECT_GE(least_phase_margin(loops, *found), radians(45.0));
  EXPECT_GT(found->derivative_s, present.derivative_s);
}

TEST(GainChoice, HoldsAtEverySpeedAndKeepsGainsThatAreGoodEnough) {
  const LoopsAtSpeeds loops{{heavy_rocket()}, {fast_rocket()}};
  const auto found = nearest_gains(loops, {1.0, 0.1}, largest, {.phase_margin_rad = radians(45.0)});
  ASSERT_TRUE(found);
  EXPECT_GE(least_phase_margin(loops, *found), radians(45.0));
  const auto again = nearest_gains(loops, *found, largest, {.phase_margin_rad = radians(45.0)});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->proportional, found->proportional);
  EXPECT_EQ(again->derivative_s, found->derivative_s);
}

TEST(GainChoice, MayLeaveOutTheShareOfAirframesThatTheDemandLeavesOut) {
  std::vector<RollLoop> airframes(20, fast_rocket());
  airframes.back().delay_s = 0.05;
  const Gains slow{.proportional = 0.3, .derivative_s = 0.051};
  EXPECT_FALSE(meets({airframes}, slow, {.phase_margin_rad = radians(45.0)}));
  EXPECT_FALSE(meets({airframes}, slow, {.phase_margin_rad = radians(45.0), .share = 0.95}));  // 5 % of 19 is none
  airframes.insert(airframes.end(), 20, fast_rocket());
  EXPECT_TRUE(meets({airframes}, slow, {.phase_margin_rad = radians(45.0), .share = 0.95}));
}

TEST(GainChoice, FindsNoneWhereNoneIs) {
  RollLoop late = fast_rocket();
  late.delay_s = 5.0;
  EXPECT_FALSE(nearest_gains({{late, heavy_rocket()}}, {1.0, 0.1}, largest, {.phase_margin_rad = radians(89.9)}));
}

TEST(GainChoice, KeepsAProportionalGainOfZero) {
  const auto found = nearest_gains({{fast_rocket()}}, {0.0, 0.5}, largest, {.phase_margin_rad = radians(45.0)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->proportional, 0.0);
  EXPECT_LT(found->derivative_s, 0.5);
}

TEST(GainChoice, TheLongestServoLagIsWhereThePhaseMarginEnds) {
  const LoopsAtSpeeds loops{{fast_rocket()}};
  const Gains gains{.proportional = 1.0, .derivative_s = 0.1};
  const PhaseMarginDemand demand{.phase_margin_rad = radians(45.0)};
  const auto lag_s = longest_servo_lag_s(loops, gains, 0.0005, demand);
  ASSERT_TRUE(lag_s);
  LoopsAtSpeeds changed = loops;
  changed[0][0].servo_lag_s = *lag_s;
  EXPECT_TRUE(meets(changed, gains, demand));
  changed[0][0].servo_lag_s = *lag_s + 2e-4;
  EXPECT_FALSE(meets(changed, gains, demand));
  EXPECT_FALSE(longest_servo_lag_s(loops, gains, 0.0005, {.phase_margin_rad = radians(89.0)}));
}

}  // namespace
}  // namespace fantail::stability
