// SPDX-License-Identifier: MIT

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "known_roll_model.hpp"
#include "rocket.hpp"
#include "state_copy.hpp"
#include "test.hpp"
#include "tunnel_run.hpp"

namespace fantail::core {
namespace {

// What the record of a tick says of the law's answer, when it has none to give or goes on from a state.

using namespace literals;

FlightPlan busy_plan() {
  FlightPlan plan = tunnel_plan();
  plan.offset.rejection = OffsetRejection::integral;
  plan.run.control_time = ms(300);
  plan.reference.kind = ReferenceKind::steps;
  plan.reference.step_times_count = plan.reference.step_angles_count = 1;
  plan.reference.step_times[0] = ms(1);
  plan.reference.step_angles[0] = 90_deg;
  plan.excitation.form = ExcitationForm::sweep;
  plan.excitation.begin = Microseconds{0};
  plan.excitation.end = ms(1'000);
  plan.excitation.amplitude_variation = Angle{};
  plan.excitation.frequency_variation_hz = 0.0F;
  return plan;
}

TEST(AutopilotRecord, AfterControlNothingOfItStays) {
  TunnelRun rig{busy_plan()};
  rig.run(200);
  const TickRecord& record = rig.tick();
  EXPECT_EQ(record.reference, 90_deg);
  EXPECT_NE(record.excitation, Angle{});
  EXPECT_NE(record.offset_estimate, Angle{});
  EXPECT_NE(record.command, Angle{});
  EXPECT_TRUE(record.saturated);
  rig.run(200);
  ASSERT_EQ(rig.law.phase(), Phase::finished);
  const TickRecord& after = rig.tick();
  EXPECT_EQ(after.reference, Angle{});
  EXPECT_EQ(after.excitation, Angle{});
  EXPECT_EQ(after.offset_estimate, Angle{});
  EXPECT_EQ(after.command, Angle{});
  EXPECT_EQ(after.unclamped_command, Angle{});
  EXPECT_FALSE(after.saturated);
}

TEST(AutopilotRecord, WithoutARateNoCommandIsAtItsLimit) {
  TunnelRun rig{busy_plan()};
  rig.run(100);
  ASSERT_TRUE(rig.tick().saturated);
  rig.inputs.gyro.quality = SampleQuality::absent;
  int ticks = 0;
  while (rig.tick().command_status != CommandStatus::gyro_lost && ticks < 100) {
    ++ticks;
  }
  const TickRecord& record = rig.tick();
  ASSERT_EQ(record.command_status, CommandStatus::gyro_lost);
  EXPECT_FALSE(record.saturated);
  EXPECT_EQ(record.command, Angle{});
}

// The record of a law that was just made says nothing yet: the estimate is that of the state.
TEST(AutopilotRecord, ALawThatGoesOnWithoutARateStillSaysItsEstimate) {
  FlightPlan plan = tunnel_plan();
  plan.offset.rejection = OffsetRejection::integral;
  TunnelRun rig{plan};
  rig.run(500, 0.1F);
  const Angle estimate = rig.tick(0.1F).offset_estimate;
  ASSERT_GT(estimate, Angle{});
  Autopilot goes_on{plan};
  copy_state(rig.law, goes_on);
  rig.wait(ms(60));
  rig.inputs.gyro.quality = SampleQuality::absent;
  goes_on.resume(rig.inputs);
  const TickRecord& record = goes_on.step(rig.inputs);
  ASSERT_EQ(record.command_status, CommandStatus::gyro_lost);
  EXPECT_EQ(record.offset_estimate, estimate);
}

// An observer sees an offset in how the rate changes: what changed it while nobody looked is no offset.
TEST(AutopilotRecord, AnObserverLearnsNothingFromTheRateAfterAGap) {
  for (const bool is_reset : {false, true}) {
    FlightPlan plan = default_plan();
    plan.offset.rejection = OffsetRejection::observer;
    plan.roll_model = known_roll_model;
    Autopilot law{plan};
    MotionRig rig;
    bool arm = false;
    bool resumes = false;
    const auto tick = [&](double rate_rad_s, bool silent = false) -> const TickRecord& {
      rig.advance(ms(1), law.phase() == Phase::safe ? 0.0 : 40.0, rate_rad_s);
      Inputs inputs = rig.inputs();
      inputs.arm_switch_closed = true;
      inputs.arm_command = arm;
      inputs.encoders.fill(Angle{});
      if (silent) {
        inputs.gyro.quality = SampleQuality::absent;
      }
      if (resumes) {
        law.resume(inputs);
      }
      return law.step(inputs);
    };
    for (int i = 0; i < 4'000; ++i) {
      tick(0.0);
    }
    arm = true;
    tick(0.0);
    arm = false;
    for (int i = 0; i < 1'500; ++i) {
      tick(0.0);
    }
    ASSERT_EQ(law.phase(), Phase::controlling);
    ASSERT_GT(tick(0.0).motion.speed_m_s, 20.0F);
    const Angle before = tick(0.0).offset_estimate;
    if (is_reset) {
      rig.advance(ms(60), 40.0, 0.0);
    } else {
      while (tick(0.0, true).command_status != CommandStatus::gyro_lost) {
        ASSERT_EQ(law.phase(), Phase::controlling);
      }
    }
    const Angle silent = is_reset ? before : tick(0.0, true).offset_estimate;
    resumes = is_reset;
    EXPECT_EQ(tick(0.1).offset_estimate, silent) << is_reset;
    resumes = false;
    EXPECT_NE(tick(0.1).offset_estimate, silent) << "and then it goes on";
  }
}

// From (4 x 5 + 6) / 3 degrees with one stuck at -6 to the 5 that each is asked for. By its encoder the canard is back
// at once; what is believed of it moves by a fiftieth of the way a tick, a third of which each of the others feels.
TEST(AutopilotRecord, ACanardThatComesBackTakesOverWithoutAStep) {
  FlightPlan plan = default_plan();
  plan.run.canard_fault = CanardFaultPolicy::share;
  plan.excitation.form = ExcitationForm::none;
  plan.reference = {};
  Rocket rocket{plan};
  rocket.fly_to_control();
  rocket.run(ms(100), 20.0, -10.0 * static_cast<double>(pi) / 18.0);
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.encoders[1] = -6_deg; });
  rocket.run(ms(500), 20.0);
  float before = rocket.record().canards[0].angle.degrees();
  EXPECT_NEAR(before, 26.0F / 3.0F, 0.01F);
  rocket.inputs_changed_by([](Inputs&) {});
  for (int i = 0; i < 300; ++i) {
    const float now = rocket.tick(20.0).canards[0].angle.degrees();
    ASSERT_LT(std::abs(now - before), 0.02F * (26.0F / 3.0F + 6.0F) / 3.0F + 0.01F) << i;
    before = now;
  }
  EXPECT_EQ(rocket.record().canards[0].angle, rocket.record().command);
}

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
