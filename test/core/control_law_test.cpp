// SPDX-License-Identifier: MIT
#include <bit>

#include "core/flight_plan_fields.hpp"
#include "core/gain_schedule.hpp"
#include "core/pd_controller.hpp"
#include "properties.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

ControllerPlan gains(float kp, float kd_s, Angle limit) {
  return {.proportional_gain = kp,
          .derivative_gain_s = kd_s,
          .rate_reference = RateReference::zero,
          .canard_limit = limit,
          .entry = ControlEntry::as_published};
}

float rad(float degrees) { return Angle::from_degrees(degrees).radians(); }

TEST(PdController, CommandIsGainTimesAngleErrorLessGainTimesRatePlusExcitation) {
  const RollCommand command = pd_controller(gains(0.5F, 0.05F, 20_deg), 10_deg, 4_deg, rad(30.0F), 2_deg);
  EXPECT_NEAR(command.unclamped.degrees(), 0.5F * (10.0F - 4.0F) - 0.05F * 30.0F + 2.0F, 1e-5F);
  EXPECT_EQ(command.command, command.unclamped);
  EXPECT_FALSE(command.saturated);
  EXPECT_TRUE(command.finite);
}

TEST(PdController, EachSignPushesAgainstItsError) {
  const ControllerPlan plan = gains(1.0F, 0.1F, 20_deg);
  EXPECT_GT(pd_controller(plan, 0_deg, -1_deg, 0.0F, 0_deg).command, 0_deg);
  EXPECT_LT(pd_controller(plan, 0_deg, 1_deg, 0.0F, 0_deg).command, 0_deg);
  EXPECT_LT(pd_controller(plan, 0_deg, 0_deg, 1.0F, 0_deg).command, 0_deg);
  EXPECT_GT(pd_controller(plan, 0_deg, 0_deg, -1.0F, 0_deg).command, 0_deg);
}

TEST(PdController, LiteralReadingComparesTheRateWithTheReferenceAngle) {
  ControllerPlan plan = gains(0.5F, 0.05F, 20_deg);
  plan.rate_reference = RateReference::paper_literal;
  const RollCommand command = pd_controller(plan, 45_deg, 30_deg, rad(10.0F), 0_deg);
  EXPECT_NEAR(command.unclamped.degrees(), 0.5F * 15.0F + 0.05F * (45.0F - 10.0F), 1e-5F);
}

TEST(PdController, AFactorIsOnBothGainsAndAnEstimateOfTheOffsetIsTakenAway) {
  const Adaptation adaptation{.gain_factor = 0.5F, .offset_estimate = 1_deg};
  const RollCommand command = pd_controller(gains(0.8F, 0.04F, 20_deg), 10_deg, 4_deg, rad(30.0F), 2_deg, adaptation);
  EXPECT_NEAR(command.before_excitation.degrees(), 0.4F * (10.0F - 4.0F) - 0.02F * 30.0F - 1.0F, 1e-5F);
  EXPECT_NEAR(command.unclamped.degrees(), 0.4F * (10.0F - 4.0F) - 0.02F * 30.0F - 1.0F + 2.0F, 1e-5F);
}

TEST(PdController, TheClampComesAfterTheExcitation) {
  // 8 deg from the law and 4 deg from the excitation: clamped first it would be 12 deg or 6 + 4.
  const RollCommand command = pd_controller(gains(1.0F, 0.0F, 6_deg), 8_deg, 0_deg, 0.0F, 4_deg);
  EXPECT_EQ(command.command, 6_deg);
  EXPECT_NEAR(command.unclamped.degrees(), 12.0F, 1e-5F);
  EXPECT_TRUE(command.saturated);
  // And an excitation may bring a command back from beyond the limit.
  EXPECT_NEAR(pd_controller(gains(1.0F, 0.0F, 6_deg), 8_deg, 0_deg, 0.0F, -4_deg).command.degrees(), 4.0F, 1e-5F);
}

TEST(PdController, SaturatesAtExactlyThePlanLimitAndSaysSoOnlyBeyondIt) {
  const ControllerPlan plan = gains(1.0F, 0.0F, 9_deg);
  const Angle just_beyond = Angle::from_radians(std::nextafter((9_deg).radians(), 1.0F));
  EXPECT_FALSE(pd_controller(plan, 9_deg, 0_deg, 0.0F, 0_deg).saturated);
  EXPECT_FALSE(pd_controller(plan, -9_deg, 0_deg, 0.0F, 0_deg).saturated);
  EXPECT_TRUE(pd_controller(plan, just_beyond, 0_deg, 0.0F, 0_deg).saturated);
  EXPECT_EQ(pd_controller(plan, just_beyond, 0_deg, 0.0F, 0_deg).command, 9_deg);
  EXPECT_EQ(pd_controller(plan, -just_beyond, 0_deg, 0.0F, 0_deg).command, -9_deg);
  EXPECT_FLOAT_EQ(pd_controller(plan, 100_deg, 0_deg, 0.0F, 0_deg).command.degrees(), 9.0F);
}

TEST(PdController, AnyInputThatIsNotFiniteGivesZeroAndSaysSo) {
  const ControllerPlan plan = gains(1.0F, 0.1F, 9_deg);
  for (const float bad : {infinity, -infinity, not_a_number}) {
    const Angle angle = Angle::from_radians(bad);
    for (const RollCommand& command :
         {pd_controller(plan, angle, 0_deg, 0.0F, 0_deg), pd_controller(plan, 0_deg, angle, 0.0F, 0_deg),
          pd_controller(plan, 0_deg, 0_deg, bad, 0_deg), pd_controller(plan, 0_deg, 0_deg, 0.0F, angle),
          pd_controller(plan, angle, angle, bad, angle)}) {
      EXPECT_FALSE(command.finite);
      EXPECT_EQ(command.command.radians(), 0.0F);
      EXPECT_EQ(command.unclamped.radians(), 0.0F);
      EXPECT_FALSE(command.saturated);
    }
  }
}

TEST(PdController, AnInputThatIsNotFiniteIsNotHiddenByAGainOfZero) {
  EXPECT_FALSE(pd_controller(gains(0.0F, 0.0F, 9_deg), 0_deg, 0_deg, not_a_number, 0_deg).finite);
}

TEST(PdController, FiniteInputsThatOverflowGiveZeroAndSaySo) {
  const RollCommand command = pd_controller(gains(10.0F, 0.0F, 9_deg), Angle::from_radians(3e38F), 0_deg, 0.0F, 0_deg);
  EXPECT_FALSE(command.finite);
  EXPECT_EQ(command.command, Angle{});
}

float any_float() {
  return *rc::gen::map<std::uint32_t>([](std::uint32_t bits) { return std::bit_cast<float>(bits); });
}

RC_GTEST_PROP(PdController, NoInputWhateverGivesACommandBeyondTheLimit, ()) {
  const Angle limit = Angle::from_degrees(static_cast<float>(*rc::gen::inRange(5, 200)) * 0.1F);
  ControllerPlan plan = gains(static_cast<float>(*rc::gen::inRange(0, 100)) * 0.1F,
                              static_cast<float>(*rc::gen::inRange(0, 20)) * 0.1F, limit);
  plan.rate_reference = *rc::gen::element(RateReference::zero, RateReference::paper_literal);
  const RollCommand command = pd_controller(plan, Angle::from_radians(any_float()), Angle::from_radians(any_float()),
                                            any_float(), Angle::from_radians(any_float()));
  RC_ASSERT(command.command <= limit && command.command >= -limit);
  RC_ASSERT(command.saturated == (command.command != command.unclamped));
}

constexpr GainSchedulePlan schedule{
    .speeds_count = 3, .speeds_m_s = {20.0F, 40.0F, 80.0F}, .factors_count = 3, .factors = {4.0F, 1.0F, 0.25F}};

float at(float speed_m_s) { return gain_factor(schedule, speed_m_s, false); }

TEST(GainSchedule, WithoutRowsTheGainsAreAsTheyStand) {
  EXPECT_EQ(gain_factor(GainSchedulePlan{}, 50.0F, false), 1.0F);
  EXPECT_EQ(gain_factor(GainSchedulePlan{}, 50.0F, true), 1.0F);
}

TEST(GainSchedule, IsLinearBetweenItsRows) {
  EXPECT_EQ(at(20.0F), 4.0F);
  EXPECT_NEAR(at(25.0F), 3.25F, 1e-6F);
  EXPECT_EQ(at(40.0F), 1.0F);
  EXPECT_NEAR(at(70.0F), 0.4375F, 1e-6F);
}

TEST(GainSchedule, HoldsItsEnds) {
  EXPECT_EQ(at(-5.0F), 4.0F);
  EXPECT_EQ(at(0.0F), 4.0F);
  EXPECT_EQ(at(80.0F), 0.25F);
  EXPECT_EQ(at(500.0F), 0.25F);
}

// A line from 10 down to 0.01 is off by a millionth where it ends, for a float of 20 knows no more.
TEST(GainSchedule, AtTheSpeedOfARowItIsThatRowHoweverSteeplyTheLineEndsThere) {
  GainSchedulePlan steep{
      .speeds_count = 3, .speeds_m_s = {20.0F, 40.0F, 80.0F}, .factors_count = 3, .factors = {10.0F, 0.01F, 0.01F}};
  EXPECT_EQ(gain_factor(steep, 40.0F, false), 0.01F);
  steep.speeds_count = steep.factors_count = 2;
  EXPECT_EQ(gain_factor(steep, 40.0F, false), 0.01F) << "the last one";
}

// The one place of a line more than there are rows is the level one before the first.
TEST(GainSchedule, MayHaveSixRows) {
  const GainSchedulePlan full{.speeds_count = 6,
                              .speeds_m_s = {10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F},
                              .factors_count = 6,
                              .factors = {32.0F, 16.0F, 8.0F, 4.0F, 2.0F, 1.0F}};
  EXPECT_EQ(gain_factor(full, 0.0F, false), 32.0F);
  for (int row = 0; row < 6; ++row) {
    EXPECT_NEAR(gain_factor(full, 10.0F * static_cast<float>(row + 1), false), static_cast<float>(1 << (5 - row)),
                1e-5F);
  }
  EXPECT_EQ(gain_factor(full, 99.0F, false), 1.0F);
}

TEST(GainSchedule, OfOneRowIsThatRowAtEverySpeed) {
  const GainSchedulePlan one{.speeds_count = 1, .speeds_m_s = {40.0F}, .factors_count = 1, .factors = {0.5F}};
  for (const float speed_m_s : {0.0F, 40.0F, 100.0F}) {
    EXPECT_EQ(gain_factor(one, speed_m_s, false), 0.5F);
  }
}

TEST(GainSchedule, ASpeedThatMayBeHigherTakesTheLastRow) { EXPECT_EQ(gain_factor(schedule, 25.0F, true), 0.25F); }

TEST(GainSchedule, ASpeedThatIsNoNumberTakesARow) {
  EXPECT_EQ(at(std::numeric_limits<float>::quiet_NaN()), 0.25F);
  EXPECT_EQ(at(std::numeric_limits<float>::infinity()), 0.25F);
}

}  // namespace

}  // namespace fantail::core
