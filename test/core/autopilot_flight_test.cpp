// SPDX-License-Identifier: MIT

#include "rocket.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr double g = 9.80665;

FlightPlan launch_2_plan() { return default_plan(); }

FlightPlan launch_1_plan() {
  FlightPlan plan = default_plan();
  plan.launch_detection.threshold_m_s2 = 2.0F * standard_gravity_m_s2;
  plan.launch_detection.hold = ms(200);
  plan.launch_detection.accelerometers = AccelerometerRule::one;
  plan.launch_detection.low_pass = false;
  plan.guide.minimum_speed_m_s = 0.0F;
  plan.motion.height_origin = HeightOrigin::velocity_only;
  return plan;
}

TEST(AutopilotFlight, ControlBeginsWhereTheGuideIsClearAndEndsAtApogee) {
  Rocket rocket{launch_2_plan()};
  rocket.arm_on_pad();
  const Microseconds hold = rocket.run_until_phase_changes(40.0, 0.3);
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
  EXPECT_NEAR(seconds(hold), 0.105F, 0.001F);  // 0.1 s and ln(4.08 / 2.58) of 9.9 ms
  EXPECT_EQ(rocket.record().motion.roll_angle, Angle{});
  rocket.run_until_phase_changes(40.0, 0.3);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_NEAR(rocket.rig.distance_m(), 6.0, 0.05);
  EXPECT_NEAR(rocket.record().motion.distance_along_guide_m, 6.0F, 0.03F);

  rocket.run(ms(1'000), 40.0, 0.3);
  rocket.run_until_phase_changes(-15.0, 0.3);
  rocket.expect(Phase::finished, PhaseReason::apogee);
  EXPECT_NEAR(rocket.rig.speed_m_s(), 0.0, 0.1);
  rocket.run(ms(1'000), -15.0, 0.3);
  rocket.expect(Phase::finished, PhaseReason::apogee);
}

TEST(AutopilotFlight, BeyondTheGuideOneGOnTheAxisIsAClimbAndNotAStand) {
  Rocket rocket{launch_2_plan()};
  rocket.fly_to_control();
  const float speed_m_s = rocket.record().motion.speed_m_s;
  rocket.run(ms(300), 0.0);  // thrust less drag is the weight: the speed stays
  EXPECT_NEAR(rocket.record().motion.speed_m_s, speed_m_s, 0.1F);
}

TEST(AutopilotFlight, ClearanceIsADistanceAlongATiltedGuide) {
  Rocket rocket{launch_2_plan()};
  rocket.rig = MotionRig{{.tilt_deg = 15.0, .azimuth_deg = 40.0}};
  rocket.fly_to_control(5.0);
  EXPECT_NEAR(rocket.rig.distance_m(), 6.0, 0.05);
}

TEST(AutopilotFlight, PositiveRollIsAnsweredByANegativeCommand) {
  Rocket rocket{launch_2_plan()};
  rocket.fly_to_control(0.5);
  EXPECT_GT(rocket.record().motion.roll_angle, Angle{});
  EXPECT_LT(rocket.record().command, Angle{});
  for (const CanardCommand& canard : rocket.record().canards) {
    EXPECT_EQ(canard.angle, rocket.record().command);
  }
}

// A knock that fires the low-passed rule (LaunchDetector, KnockOf16GFor80Ms...). The speed it seems to leave behind,
// 11.8 m/s, would pass for a cleared guide 0.5 s later.
TEST(AutopilotFlight, TheGainScheduleWeakensTheCommandOfAPlanThatHasNothingElseToAdapt) {
  FlightPlan plan = launch_2_plan();
  plan.gain_schedule.speeds_count = plan.gain_schedule.factors_count = 1;
  plan.gain_schedule.speeds_m_s = {30.0F};
  plan.gain_schedule.factors = {0.5F};
  Rocket scheduled{plan};
  Rocket constant{launch_2_plan()};
  scheduled.fly_to_control();
  constant.fly_to_control();
  const Angle half = scheduled.run(ms(100), 40.0, 0.3).command;
  const Angle whole = constant.run(ms(100), 40.0, 0.3).command;
  EXPECT_LT(whole, Angle{});
  EXPECT_NEAR(half.radians(), 0.5F * whole.radians(), 1e-6F);
}

TEST(AutopilotFlight, KnockThatFiresTheLowPassedRuleNeverMovesACanard) {
  // It still stands in the guide; or it was thrown up in it, which leaves the low-passed output 5 ms sooner.
  for (const auto& [after_g, length] : {std::pair{1.0, ms(80)}, {0.0, ms(85)}}) {
    Rocket rocket{launch_2_plan()};
    rocket.arm_on_pad();
    rocket.run(length, 15.0 * g);
    rocket.run_until_phase_changes((after_g - 1.0) * g);
    rocket.expect(Phase::launched, PhaseReason::launch_detected);
    EXPECT_EQ(rocket.run_until_phase_changes((after_g - 1.0) * g), ms(1'500));
    rocket.expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);

    // A real launch right behind it is not believed; after 3.6 seconds at rest, when the attitude is taken anew, it is.
    rocket.run(ms(1'900));
    rocket.run(ms(600), 40.0);
    rocket.expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
    rocket.run(ms(3'800));
    rocket.run_until_phase_changes(40.0);
    rocket.expect(Phase::launched, PhaseReason::launch_detected);
    rocket.run_until_phase_changes(40.0);
    rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  }
}

TEST(AutopilotFlight, KnockDoesNotPassTheRuleWithoutASpeedGateEither) {
  Rocket rocket{launch_1_plan()};
  rocket.arm_on_pad();
  rocket.run(ms(205), 8.0 * g);  // 16 m/s: 6 m would be through in 0.4 s
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
  rocket.run_until_phase_changes();
  rocket.expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
}

TEST(AutopilotFlight, GyroThatIsLostGivesANeutralCommandForAsLongAsThePlanSaysThenEndsControl) {
  FlightPlan plan = launch_2_plan();
  plan.motion.longest_gyro_gap = ms(80);
  Rocket rocket{plan};
  rocket.fly_to_control(0.5);
  rocket.run(ms(100), 40.0, 0.5);
  EXPECT_NE(rocket.record().command, Angle{});
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.gyro.quality = SampleQuality::invalid; });
  for (int i = 1; i <= 80; ++i) {
    const TickRecord& record = rocket.tick(40.0, 0.5);
    EXPECT_EQ(record.phase, Phase::controlling);
    EXPECT_EQ(record.command_status, CommandStatus::gyro_lost);
    EXPECT_EQ(record.command, Angle{});
  }
  rocket.tick(40.0, 0.5);
  rocket.expect(Phase::finished, PhaseReason::gyro_failed);
}

TEST(AutopilotFlight, CommandReturnsAfterAShortLossOfTheGyro) {
  Rocket rocket{launch_2_plan()};
  rocket.fly_to_control(0.5);
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.gyro = {}; });
  rocket.run(ms(4), 40.0, 0.5);
  rocket.inputs_changed_by([](Inputs&) {});
  EXPECT_EQ(rocket.tick(40.0, 0.5).command_status, CommandStatus::controlling);
  EXPECT_NE(rocket.record().command, Angle{});
}

TEST(AutopilotFlight, AfterASilenceOfTheGyroControlGoesOnWithTheAngleThatARateGoneEvenlyGives) {
  Rocket rocket{launch_2_plan()};
  rocket.fly_to_control(0.5);
  rocket.run(ms(100), 40.0, 0.5);
  EXPECT_FALSE(rocket.record().motion.roll_is_bridged);
  const double zero_rad = rocket.rig.roll_rad() - static_cast<double>(rocket.record().motion.roll_angle.radians());
  rocket.inputs_changed_by([](Inputs& inputs) { inputs.gyro = {}; });
  for (int i = 0; i < 100; ++i) {  // from 0.5 to 2.5 rad/s, evenly
    rocket.tick(40.0, 0.5 + 0.02 * i);
  }
  rocket.inputs_changed_by([](Inputs&) {});
  for (int i = 1; i < 5; ++i) {
    EXPECT_EQ(rocket.tick(40.0, 2.5).command_status, CommandStatus::gyro_lost) << i;
  }
  const TickRecord& back = rocket.tick(40.0, 2.5);
  EXPECT_EQ(back.phase, Phase::controlling);
  EXPECT_EQ(back.command_status, CommandStatus::controlling);
  EXPECT_TRUE(back.motion.roll_is_bridged);
  // The five samples that were waited for count as part of the gap: 5 ms of at most 1 rad/s.
  EXPECT_NEAR(back.motion.roll_angle.radians(), rocket.rig.roll_rad() - zero_rad, 0.006);
}

TEST(AutopilotFlight, AGyroAtTheEndOfItsRangeIsARateToActAgainst) {
  Rocket rocket{launch_2_plan()};
  rocket.fly_to_control(0.5);
  rocket.inputs_changed_by([](Inputs& inputs) {
    constexpr float end_rad_s = 30.0F;
    if (inputs.gyro.rate_rad_s.x > end_rad_s) {
      inputs.gyro.rate_rad_s.x = end_rad_s;
      inputs.gyro.quality = SampleQuality::saturated;
    }
  });
  for (int i = 0; i < 400; ++i) {
    rocket.tick(40.0, 0.5 + 0.1 * i);
  }
  const TickRecord& record = rocket.record();
  EXPECT_EQ(record.phase, Phase::controlling);
  EXPECT_TRUE(record.motion.rate_is_lower_bound);
  EXPECT_TRUE(record.motion.roll_is_bridged);
  EXPECT_EQ(record.motion.roll_rate_rad_s, 30.0F);
  EXPECT_EQ(record.command, -launch_2_plan().controller.canard_limit);
}

TEST(AutopilotFlight, TickThatComesTwiceOrSixMillisecondsLateEndsControl) {
  for (const int late_ms : {0, 5, 6}) {
    Rocket rocket{launch_2_plan()};
    rocket.fly_to_control();
    rocket.inputs_changed_by([&](Inputs& inputs) { inputs.time += ms(late_ms - 1); });
    rocket.tick(40.0, 0.0);
    if (late_ms == 5) {
      rocket.expect(Phase::controlling, PhaseReason::guide_clear);
    } else {
      rocket.expect(Phase::finished, PhaseReason::timing_fault);
      EXPECT_TRUE(rocket.record().timing_fault);
    }
  }
}

TEST(AutopilotFlight, TunnelRunCountsRollAndReferenceFromItsStart) {
  FlightPlan plan = tunnel_plan();
  plan.reference.kind = ReferenceKind::steps;
  plan.reference.step_times_count = plan.reference.step_angles_count = 1;
  plan.reference.step_times[0] = ms(100);
  plan.reference.step_angles[0] = Angle::from_degrees(5.0F);
  Rocket rocket{plan};
  rocket.arm_on_pad();
  rocket.command_once([](Inputs& inputs) { inputs.start_command = true; });
  rocket.expect(Phase::controlling, PhaseReason::tunnel_start_command);
  EXPECT_EQ(rocket.record().motion.roll_angle, Angle{});
  EXPECT_EQ(rocket.run(ms(99)).reference, Angle{});
  EXPECT_EQ(rocket.run(ms(1)).reference, plan.reference.step_angles[0]);
  EXPECT_NEAR(rocket.record().command.degrees(), 2.5F, 1e-4F);
}

TEST(AutopilotFlight, TunnelStartIsRefusedWhileTheRocketTurns) {
  Rocket rocket{tunnel_plan()};
  rocket.arm_on_pad();
  rocket.run(ms(100), 0.0, 1.0);
  rocket.run(ms(1'900));
  rocket.command_once([](Inputs& inputs) { inputs.start_command = true; });
  rocket.expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

TEST(AutopilotFlight, CanardRequestIsObeyedInSafeOnlyAndInsideTheLimit) {
  Rocket rocket{launch_2_plan()};
  std::array<Angle, canard_count> request;
  request.fill(Angle::from_degrees(30.0F));
  rocket.inputs_changed_by([&](Inputs& inputs) { inputs.canard_request = request; });
  rocket.run(ms(4'000));
  EXPECT_EQ(rocket.record().canards[0].angle, launch_2_plan().controller.canard_limit);
  rocket.arm();
  EXPECT_EQ(rocket.tick().canards[0].angle, Angle{});
}

TEST(AutopilotFlight, SameInputsGiveTheSameRecordTwice) {
  Rocket first{launch_2_plan()};
  Rocket second{launch_2_plan()};
  first.fly_to_control(1.0);
  second.fly_to_control(1.0);
  for (int i = 0; i < 500; ++i) {
    const TickRecord& a = first.tick(30.0, 1.0);
    const TickRecord& b = second.tick(30.0, 1.0);
    ASSERT_EQ(a.command, b.command);
    ASSERT_EQ(a.motion.height_m, b.motion.height_m);
  }
}

TEST(AutopilotFlight, HoursOnThePadChangeNothing) {
  for (const std::int64_t hours : {0, 48}) {
    Rocket rocket{launch_2_plan()};
    rocket.rig.advance(Microseconds{hours * 3'600'000'000}, 0.0, 0.0);
    rocket.fly_to_control(2.0);
    EXPECT_NEAR(rocket.rig.distance_m(), 6.0, 0.05);
    rocket.run(ms(2'000), 20.0, 2.0);
    // From detection: 2 rad/s over the 0.44 s to guide clearance and the 2 s since.
    EXPECT_NEAR(rocket.record().motion.roll_angle.radians(), 4.88F, 0.02F);
  }
}

}  // namespace
}  // namespace fantail::core
