// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "rocket.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr std::size_t broken = 1;

FlightPlan plan_that(CanardFaultPolicy policy) {
  FlightPlan plan = default_plan();
  plan.run.canard_fault = policy;
  plan.excitation.form = ExcitationForm::none;
  plan.reference = {};  // zero throughout
  return plan;
}

/// Under control, turned to `roll` and at rest there, with a canard that has stood at `at` for `since`.
Rocket with_a_stuck_canard(const FlightPlan& plan, double roll_deg, Angle at, Microseconds since = ms(500)) {
  Rocket rocket{plan};
  rocket.fly_to_control();
  rocket.run(ms(100), 20.0, roll_deg * static_cast<double>(pi) / 18.0);
  rocket.inputs_changed_by([at](Inputs& inputs) { inputs.encoders[broken] = at; });
  rocket.run(since, 20.0);
  EXPECT_EQ(rocket.record().phase, Phase::controlling);
  return rocket;
}

constexpr float near_deg = 0.01F;

// kp of 0.5: at a roll angle of -10 degrees the command is 5, and of four canards three are left.
TEST(AutopilotSharing, ThreeCanardsDoWhatFourWereAskedFor) {
  for (const Angle at : {0_deg, -3_deg, 9_deg}) {
    const Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -10.0, at);
    const TickRecord& record = rocket.record();
    EXPECT_NEAR(record.command.degrees(), 5.0F, near_deg);
    EXPECT_NEAR(record.canards[0].angle.degrees(), (20.0F - at.degrees()) / 3.0F, near_deg);
    EXPECT_NEAR(record.canard_angle.value_or(90_deg).degrees(), 5.0F, near_deg);
    EXPECT_FALSE(record.saturated);
  }
}

TEST(AutopilotSharing, APlanThatOnlyContinuesSharesNothing) {
  const Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::continue_control), -10.0, 0_deg);
  for (const CanardCommand& canard : rocket.record().canards) {
    EXPECT_EQ(canard.angle, rocket.record().command);
  }
}

// Trim and sign of each canard stay its own: the stuck one is reversed and stands 3 degrees from its trim.
TEST(AutopilotSharing, GoesByTheAngleFromTrimInTheSenseOfRoll) {
  FlightPlan plan = plan_that(CanardFaultPolicy::share);
  plan.canards.each[broken].direction = Direction::reversed;
  plan.canards.each[broken].trim = 2_deg;
  const Rocket rocket = with_a_stuck_canard(plan, -10.0, 5_deg);
  EXPECT_NEAR(rocket.record().canards[0].angle.degrees(), (20.0F + 3.0F) / 3.0F, near_deg);
}

// (4 u - a) / 3 = 9 at u = 6.75: more than that is no command.
TEST(AutopilotSharing, TheCommandIsWhatTheCanardsCanMake) {
  const Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -30.0, 0_deg);
  EXPECT_NEAR(rocket.record().unclamped_command.degrees(), 15.0F, near_deg);
  EXPECT_NEAR(rocket.record().command.degrees(), 6.75F, near_deg);
  EXPECT_NEAR(rocket.record().canards[0].angle.degrees(), 9.0F, near_deg);
  EXPECT_TRUE(rocket.record().saturated);
}

// At its stop on the helpful side it adds 25, and with the others at 9 that would be 13: the law has its 12, and the
// record does not say more than the plan limit.
TEST(AutopilotSharing, AStuckCanardThatHelpsIsUsed) {
  const Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -24.0, 25_deg);
  EXPECT_EQ(rocket.record().command, 9_deg);
  EXPECT_NEAR(rocket.record().canards[0].angle.degrees(), (48.0F - 25.0F) / 3.0F, 0.05F);
  EXPECT_FALSE(rocket.record().saturated);
}

// An encoder that has come off shows what no shaft can: it must not throw three good canards to their limits.
TEST(AutopilotSharing, AnAngleBeyondTheStopIsNotBelieved) {
  const Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -10.0, 90_deg);
  EXPECT_EQ(name(rocket.record().verdicts[broken]), name(CanardVerdict::stalled));
  EXPECT_EQ(rocket.record().canards[0].angle, rocket.record().command);
}

// The command is zero without a rate; that is: no roll moment, and so two degrees against the six of the stuck one.
TEST(AutopilotSharing, WhileTheGyroIsSilentTheOthersUndoTheStuckOne) {
  Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -10.0, -6_deg);
  rocket.inputs_changed_by([](Inputs& inputs) {
    inputs.encoders[broken] = -6_deg;
    inputs.gyro.quality = SampleQuality::absent;
  });
  while (rocket.record().command_status != CommandStatus::gyro_lost && rocket.record().phase == Phase::controlling) {
    rocket.tick(20.0);
  }
  ASSERT_EQ(name(rocket.record().command_status), name(CommandStatus::gyro_lost));
  EXPECT_EQ(rocket.record().command, Angle{});
  EXPECT_NEAR(rocket.record().canards[0].angle.degrees(), 2.0F, near_deg);
}

TEST(AutopilotSharing, OutsideOfControlEveryCanardStandsAtItsTrim) {
  Rocket rocket = with_a_stuck_canard(plan_that(CanardFaultPolicy::share), -10.0, -6_deg);
  rocket.run_until_phase_changes(-15.0);
  rocket.expect(Phase::finished, PhaseReason::apogee);
  for (const CanardCommand& canard : rocket.record().canards) {
    EXPECT_EQ(canard.angle, Angle{});
  }
}

}  // namespace
}  // namespace fantail::core
