// SPDX-License-Identifier: MIT
#include "core/capture.hpp"

#include <random>

#include "core/flight_plan_fields.hpp"
#include "known_roll_model.hpp"
#include "seed.hpp"
#include "state_copy.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

FlightPlan capturing_plan(const RollModelPlan& model = known_roll_model) {
  FlightPlan plan = default_plan();
  plan.controller.entry = ControlEntry::capture;
  plan.roll_model = model;
  return plan;
}

Motion spinning(float angle_rad, float rate_rad_s, float speed_m_s) {
  Motion motion;
  motion.gyro = SensorState::fresh;
  motion.roll_angle = Angle::from_radians(angle_rad);
  motion.roll_rate_rad_s = rate_rad_s;
  motion.speed_m_s = speed_m_s;
  return motion;
}

double whole_turns(Angle turned) { return static_cast<double>(turned.radians()) / (2.0 * std::numbers::pi); }

// (phi + stop p + pi f - R) / 2 pi, not yet rounded; in double precision, and from the plan's numbers alone.
double turns_ahead(const Motion& m, double stop_s, double share, double reference_rad) {
  const auto rate = static_cast<double>(m.roll_rate_rad_s);
  return (static_cast<double>(m.roll_angle.radians()) + stop_s * rate + std::numbers::pi * share - reference_rad) /
         (2.0 * std::numbers::pi);
}

class Draw {
 public:
  float between(float low, float high) { return std::uniform_real_distribution{low, high}(random_); }
  Motion motion() { return spinning(between(-60.0F, 60.0F), between(-26.0F, 26.0F), between(10.5F, 300.0F)); }

 private:
  std::mt19937 random_{test::seed()};
};

TEST(Capture, ChoosesTheWholeTurnOfTheFormulaFromAnyState) {
  Draw draw;
  for (int i = 0; i < 100'000; ++i) {
    const RollModelPlan model{.roll_inertia_kg_m2 = draw.between(0.001F, 0.1F),
                              .reference_area_m2 = draw.between(5e-5F, 5e-4F),
                              .damping_m2 = draw.between(5.0F, 60.0F),
                              .torque_m = draw.between(4.0F, 20.0F),
                              .density_kg_m3 = draw.between(0.5F, 1.3F)};
    const FlightPlan plan = capturing_plan(model);
    Capture capture{plan};
    const Motion motion = draw.motion();
    const Angle reference = Angle::from_radians(draw.between(-12.0F, 12.0F));
    const double chosen = whole_turns(capture.begin(motion, reference));

    const auto damping = static_cast<double>(model.damping_m2);
    const double c = static_cast<double>(model.density_kg_m3) * static_cast<double>(model.reference_area_m2) * damping /
                     (2.0 * static_cast<double>(model.roll_inertia_kg_m2));
    const auto speed = static_cast<double>(motion.speed_m_s);
    const double offset =
        damping * static_cast<double>(motion.roll_rate_rad_s) / (static_cast<double>(model.torque_m) * speed);  // Eq 27
    const double share = std::clamp(offset / static_cast<double>(plan.controller.canard_limit.radians()), -0.9, 0.9);
    const double ahead = turns_ahead(motion, 1.0 / (c * speed), share, static_cast<double>(reference.radians()));
    if (std::abs(ahead - std::floor(ahead) - 0.5) > 1e-3) {
      ASSERT_NEAR(chosen, std::round(ahead), 1e-6 * std::max(1.0, std::abs(ahead))) << i;  // a float of n turns
    }
    ASSERT_NEAR(chosen, ahead, 0.501) << i;
  }
}

TEST(Capture, WithoutARollModelGoesByTheGainsAndTheSenseOfTheSpin) {
  Draw draw;
  const FlightPlan plan = capturing_plan(RollModelPlan{});
  for (int i = 0; i < 100'000; ++i) {
    Capture capture{plan};
    const Motion motion = draw.motion();
    capture.watch(motion);
    const double chosen = whole_turns(capture.begin(motion, Angle{}));
    EXPECT_FALSE(capture.offset());
    const double ahead = turns_ahead(motion, 0.05 / 0.5, motion.roll_rate_rad_s > 0.0F ? 0.5 : -0.5, 0.0);
    if (std::abs(ahead - std::floor(ahead) - 0.5) > 1e-3) {
      ASSERT_NEAR(chosen, std::round(ahead), 1e-5) << i;
    }
  }
}

TEST(Capture, WhereTheSpeedTellsNothingGoesByTheGainsToo) {
  for (const bool slow : {true, false}) {
    Capture capture{capturing_plan()};
    Motion motion = spinning(2.0F, 9.0F, slow ? 9.9F : 90.0F);
    motion.speed_is_lower_bound = !slow;
    capture.watch(motion);
    const double chosen = whole_turns(capture.begin(motion, Angle{}));
    EXPECT_FALSE(capture.offset());
    EXPECT_NEAR(chosen, std::round(turns_ahead(motion, 0.1, 0.5, 0.0)), 1e-6);
  }
}

TEST(Capture, OfARocketThatStandsStillTakesTheNearestTurn) {
  for (const auto& [angle_deg, expected] : {std::pair{170.0F, 0}, std::pair{190.0F, 1}, std::pair{-550.0F, -2}}) {
    Capture capture{capturing_plan(RollModelPlan{})};
    const Motion still = spinning(Angle::from_degrees(angle_deg).radians(), 0.0F, 60.0F);
    EXPECT_NEAR(whole_turns(capture.begin(still, Angle{})), expected, 1e-6) << angle_deg;
  }
}

TEST(Capture, WhatIsNoNumberAsksForNoTurn) {
  Capture capture{capturing_plan()};
  EXPECT_EQ(capture.begin(spinning(std::nanf(""), 3.0F, 60.0F), Angle{}), Angle{});
}

double offset_deg(const Capture& capture) { return static_cast<double>(capture.offset()->degrees()); }

// By the spin alone an offset of -3 degrees would be one of +23 at the beginning.
TEST(Capture, IsNotDeceivedByASpinThatTheOffsetDidNotCause) {
  Capture capture{capturing_plan()};
  RollingRocket rocket{12.6};
  for (int i = 0; i < 1'200; ++i) {
    capture.watch(spinning(0.0F, static_cast<float>(rocket.rate_rad_s), 80.0F));
    if (i == 0) {
      EXPECT_NEAR(offset_deg(capture), 23.0 / 9.0 * 12.6 / 80.0 * 180.0 / std::numbers::pi, 0.01);
    }
    rocket.turn(0.0, -3.0 * std::numbers::pi / 180.0, 80.0);
  }
  EXPECT_NEAR(offset_deg(capture), -3.0, 26.0 * std::exp(-6.0 * 1.2) + 0.02);
}

TEST(Capture, WhatTurnedTheRocketWhileNobodyLookedIsNoOffset) {
  for (const bool reset : {true, false}) {
    Capture capture{capturing_plan()};
    for (int i = 0; i < 100; ++i) {
      capture.watch(spinning(0.0F, 1.0F, 60.0F));
    }
    const double before_deg = offset_deg(capture);
    if (reset) {
      capture.interrupt();
    } else {
      Motion silent = spinning(0.0F, 1.0F, 60.0F);
      silent.gyro = SensorState::lost;
      capture.watch(silent);
    }
    capture.watch(spinning(0.0F, 6.0F, 60.0F));
    EXPECT_EQ(offset_deg(capture), before_deg);
    capture.watch(spinning(0.0F, 6.0F, 60.0F));
    EXPECT_NE(offset_deg(capture), before_deg);
  }
}

TEST(Capture, OneThatIsGivenTheStateOfAnotherGoesOnAsTheOtherDoes) {
  Capture capture{capturing_plan()};
  for (int i = 0; i < 50; ++i) {
    capture.watch(spinning(0.0F, 1.0F + 0.01F * static_cast<float>(i), 60.0F));
  }
  Capture given{capturing_plan()};
  copy_state(capture, given);
  std::vector<Angle> turned;
  for (Capture* one : {&capture, &given}) {
    one->watch(spinning(0.0F, 2.0F, 60.0F));
    turned.push_back(one->begin(spinning(20.0F, 2.0F, 60.0F), 30_deg));
  }
  EXPECT_EQ(offset_deg(given), offset_deg(capture));
  EXPECT_EQ(turned[1], turned[0]);
  EXPECT_NE(turned[0], Angle{});
}

}  // namespace
}  // namespace fantail::core
