// SPDX-License-Identifier: MIT
#include "core/pd_controller.hpp"
#include "core/roll_reference.hpp"
#include "known_roll_model.hpp"
#include "rocket.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr double thrust_m_s2 = 40.0;  // less gravity
constexpr double coast_m_s2 = -12.0;

FlightPlan gated_plan(DormantUntil until = DormantUntil::burn_out) {
  FlightPlan plan = default_plan();
  plan.dormancy.until = until;
  plan.dormancy.burn_time = ms(1'500);
  plan.controller.entry = ControlEntry::capture;
  plan.roll_model = known_roll_model;
  return plan;
}

/// Beyond the guide, spinning, and dormant.
Rocket dormant_rocket(const FlightPlan& plan, double rate_rad_s) {
  Rocket rocket{plan};
  rocket.arm_on_pad();
  rocket.run_until_phase_changes(thrust_m_s2, rate_rad_s);
  rocket.run_until_phase_changes(thrust_m_s2, rate_rad_s);
  rocket.expect(Phase::dormant, PhaseReason::guide_clear);
  return rocket;
}

double turns(Angle angle) { return static_cast<double>(angle.degrees()) / 360.0; }

TEST(AutopilotGate, TheCanardsOfASpinningRocketStandAtTrimUntilTheGateOpens) {
  FlightPlan plan = gated_plan();
  for (std::size_t i = 0; i < canard_count; ++i) {
    plan.canards.each[i].trim = Angle::from_degrees(0.5F * static_cast<float>(i));
  }
  Rocket rocket = dormant_rocket(plan, 7.0);
  int ticks = 0;
  for (; rocket.record().phase == Phase::dormant; ++ticks) {
    for (std::size_t i = 0; i < canard_count; ++i) {
      ASSERT_EQ(rocket.record().canards[i].angle, plan.canards.each[i].trim);
    }
    ASSERT_EQ(rocket.record().reference, Angle{});
    rocket.tick(ticks < 1'200 ? thrust_m_s2 : coast_m_s2, 7.0);
  }
  EXPECT_GT(ticks, 1'200);
  rocket.expect(Phase::controlling, PhaseReason::gate_open);
  EXPECT_NE(rocket.record().command, Angle{});
}

TEST(AutopilotGate, ControlBeginsWithWholeTurnsOnTheReferenceAndKeepsThem) {
  Rocket rocket = dormant_rocket(gated_plan(), 7.0);
  rocket.run(ms(1'200), thrust_m_s2, 7.0);
  rocket.run_until_phase_changes(coast_m_s2, 7.0);
  const Angle reference = rocket.record().reference;
  EXPECT_NEAR(turns(reference), std::round(turns(reference)), 1e-5);
  EXPECT_NEAR(turns(reference), turns(rocket.record().motion.roll_angle), 1.5);
  EXPECT_GE(std::abs(turns(reference)), 1.0);
  rocket.run(ms(500), coast_m_s2, -3.0);
  EXPECT_EQ(rocket.record().reference, reference) << "chosen once";
}

// What Dormant shows is what capture begins with; a law that rejects nothing takes nothing off.
TEST(AutopilotGate, TheRecordHasTheOffsetOfTheLawUnderControlAndThatOfCaptureBefore) {
  for (const OffsetRejection rejection : {OffsetRejection::none, OffsetRejection::observer}) {
    FlightPlan plan = gated_plan();
    plan.offset.rejection = rejection;
    Rocket rocket = dormant_rocket(plan, 2.0);
    rocket.run(ms(1'200), thrust_m_s2, 2.0);
    const Angle dormant = rocket.record().offset_estimate;
    EXPECT_GT(abs(dormant), 1_deg);
    rocket.run_until_phase_changes(coast_m_s2, 2.0);
    rocket.expect(Phase::controlling, PhaseReason::gate_open);
    const Angle begun = rocket.record().offset_estimate;
    EXPECT_TRUE(rejection == OffsetRejection::none ? begun == Angle{} : abs(begun) > 1_deg);
  }
}

TEST(AutopilotGate, AMotorThatPushesAgainBringsTheCanardsToTrimAndTheNextTurnIsChosenAnew) {
  Rocket rocket = dormant_rocket(gated_plan(), 7.0);
  rocket.run(ms(1'200), thrust_m_s2, 7.0);
  rocket.run_until_phase_changes(coast_m_s2, 7.0);
  const Angle first = rocket.record().reference;
  rocket.run_until_phase_changes(thrust_m_s2, 20.0);
  rocket.expect(Phase::dormant, PhaseReason::gate_closed_again);
  EXPECT_EQ(rocket.record().command, Angle{});
  rocket.run(ms(600), thrust_m_s2, 20.0);
  rocket.run_until_phase_changes(coast_m_s2, 20.0);
  rocket.expect(Phase::controlling, PhaseReason::gate_open);
  EXPECT_GT(turns(rocket.record().reference), turns(first) + 0.9);
}

TEST(AutopilotGate, AGyroThatIsSilentAsTheGateOpensIsWaitedFor) {
  Rocket rocket = dormant_rocket(gated_plan(), 1.0);
  rocket.run(ms(1'200), thrust_m_s2, 1.0);
  rocket.run(ms(100), coast_m_s2, 1.0);
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.gyro.quality = SampleQuality::absent; });
  rocket.run(ms(200), coast_m_s2, 1.0);
  rocket.expect(Phase::dormant, PhaseReason::guide_clear);
  rocket.inputs_changed_by([](Inputs&) {});
  EXPECT_LE(rocket.run_until_phase_changes(coast_m_s2, 1.0), ms(5));
  rocket.expect(Phase::controlling, PhaseReason::gate_open);
}

TEST(AutopilotGate, AResetWhileDormantKeepsTheFlightItsClockAndItsHold) {
  Rocket rocket = dormant_rocket(gated_plan(), 1.0);
  rocket.run(ms(1'200), thrust_m_s2, 1.0);
  rocket.run(ms(60), coast_m_s2, 1.0);
  rocket.resume(ms(120), coast_m_s2, 1.0);
  rocket.expect(Phase::dormant, PhaseReason::guide_clear);
  EXPECT_FALSE(rocket.record().timing_fault);
  EXPECT_NEAR(static_cast<double>(rocket.run_until_phase_changes(coast_m_s2, 1.0).count()), 100e3, 1.5e3)
      << "the hold begins anew";
  rocket.expect(Phase::controlling, PhaseReason::gate_open);
}

TEST(AutopilotGate, TooManyTicksThatDoNotComeEndDormancy) {
  FlightPlan plan = gated_plan();
  plan.run.overrun_limit = 0;
  Rocket rocket = dormant_rocket(plan, 0.0);
  rocket.rig.advance(ms(1), thrust_m_s2, 0.0);
  rocket.tick(thrust_m_s2);
  rocket.expect(Phase::finished, PhaseReason::timing_fault);
}

TEST(AutopilotGate, AnAbortEndsDormancyAtTrim) {
  Rocket rocket = dormant_rocket(gated_plan(), 3.0);
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.abort = true; });
  rocket.tick(thrust_m_s2, 3.0);
  rocket.expect(Phase::finished, PhaseReason::aborted);
}

// Of a rocket that leans as its guide did the axis has not turned.
TEST(AutopilotGate, TheTiltFromTheGuideIsThereWhereThePlanCountsFromIt) {
  for (const TiltOrigin origin : {TiltOrigin::vertical, TiltOrigin::guide}) {
    FlightPlan plan = default_plan();
    plan.run.tilt_from = origin;
    plan.run.tilt_limit = 20_deg;
    Rocket rocket{plan};
    rocket.rig = MotionRig{{.tilt_deg = 25.0, .azimuth_deg = 40.0}};
    rocket.arm_on_pad();
    rocket.run_until_phase_changes(thrust_m_s2);
    rocket.run_until_phase_changes(thrust_m_s2);
    rocket.run(ms(100), thrust_m_s2);
    EXPECT_EQ(rocket.record().motion.tilt_from_guide.has_value(), origin == TiltOrigin::guide);
    if (origin == TiltOrigin::guide) {
      EXPECT_NEAR(rocket.record().motion.tilt_from_guide->degrees(), 0.0F, 0.1F);
      rocket.expect(Phase::controlling, PhaseReason::guide_clear);
    } else {
      rocket.expect(Phase::finished, PhaseReason::tilted_too_far);
    }
  }
}

// Whatever else the plan says of gates and models.
TEST(AutopilotGate, EnteredAsPublishedEveryCommandIsThatOfThePublishedLawToTheBit) {
  FlightPlan plan = default_plan();
  plan.roll_model = known_roll_model;
  plan.dormancy = gated_plan().dormancy;
  plan.dormancy.until = DormantUntil::guide;
  plan.reference.initial = 30_deg;
  Rocket published{default_plan()};
  Rocket rocket{plan};
  published.fly_to_control();
  rocket.fly_to_control();
  int saturated = 0;
  for (int i = 0; i < 3'000; ++i) {
    const double rate_rad_s = 7.0 * std::cos(0.004 * i);
    const TickRecord& record = rocket.tick(0.0, rate_rad_s);
    ASSERT_EQ(record.phase, Phase::controlling);
    ASSERT_EQ(record.reference, roll_reference(plan.reference, ms(i + 1)));
    const RollCommand law = pd_controller(plan.controller, plan.reference.initial, record.motion.roll_angle,
                                          record.motion.roll_rate_rad_s, Angle{});
    ASSERT_EQ(record.command, law.command) << i;
    saturated += law.saturated ? 1 : 0;
    ASSERT_EQ(record.motion.roll_angle, published.tick(0.0, rate_rad_s).motion.roll_angle);
  }
  EXPECT_LT(saturated, 3'000);
}

}  // namespace
}  // namespace fantail::core
