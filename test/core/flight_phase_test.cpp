// SPDX-License-Identifier: MIT
#include "core/flight_phase.hpp"

#include "phase_sequence.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

TEST(FlightPhase, StartsInSafe) { Sequence{}.expect(Phase::safe, PhaseReason::power_on); }

TEST(FlightPhase, NeitherTheSwitchNorTheCommandAloneArms) {
  Sequence sequence;
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(sequence.tick());  // the switch
  }
  sequence.next.arm_switch_closed = false;
  EXPECT_FALSE(sequence.tick([](Tick& i) { i.arm_command = true; }));
  sequence.next.arm_switch_closed = true;  // a command of before does not count
  EXPECT_FALSE(sequence.tick());
  sequence.expect(Phase::safe, PhaseReason::power_on);
}

TEST(FlightPhase, SwitchThenCommandArms) {
  Sequence sequence;
  EXPECT_TRUE(sequence.tick([](Tick& i) { i.arm_command = true; }));
  sequence.expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
  EXPECT_TRUE(sequence.phases().listens_for_launch());
}

TEST(FlightPhase, SafeListensToNothingElse) {
  Sequence sequence;
  sequence.next.launch_detected = sequence.next.start_command = true;
  sequence.next.motion.at_rest_for = ms(10'000);
  sequence.next.motion.distance_along_guide_m = 100.0F;
  sequence.next.motion.speed_m_s = 100.0F;
  EXPECT_FALSE(sequence.tick());
  EXPECT_FALSE(sequence.phases().listens_for_launch());
}

TEST(FlightPhase, OpenSwitchDisarmsEvenInTheTickOfADetection) {
  Sequence sequence;
  sequence.arm();
  sequence.tick([](Tick& i) {
    i.arm_switch_closed = false;
    i.launch_detected = true;
  });
  sequence.expect(Phase::safe, PhaseReason::disarmed_by_switch);
  sequence.tick();  // closing it again arms nothing
  sequence.expect(Phase::safe, PhaseReason::disarmed_by_switch);
}

TEST(FlightPhase, SwitchIsIgnoredFromLaunchedOn) {
  Sequence sequence;
  sequence.arm().launch().expect(Phase::launched, PhaseReason::launch_detected);
  sequence.next.arm_switch_closed = false;
  EXPECT_FALSE(sequence.tick());
  sequence.clear_guide().expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_FALSE(sequence.tick());
  sequence.next.motion.vertical_speed_m_s = -0.1F;
  sequence.tick();
  sequence.expect(Phase::finished, PhaseReason::apogee);
  EXPECT_FALSE(sequence.tick());
}

TEST(FlightPhase, GuideIsClearOnlyBeyondItAndFastEnough) {
  const FlightPlan plan = default_plan();
  const float end = plan.guide.length_m + plan.guide.clearance_m;
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.motion.distance_along_guide_m = end - 0.001F;
  sequence.next.motion.speed_m_s = 50.0F;
  EXPECT_FALSE(sequence.tick());
  sequence.next.motion.distance_along_guide_m = end;
  sequence.next.motion.speed_m_s = plan.guide.minimum_speed_m_s;
  EXPECT_FALSE(sequence.tick());
  sequence.next.motion.speed_m_s = plan.guide.minimum_speed_m_s + 0.001F;
  EXPECT_TRUE(sequence.tick());
  sequence.expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_EQ(sequence.phases().control_start(), sequence.next.time);
}

TEST(FlightPhase, GuideIsNotClearWhileTwoAccelerometersDisagree) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.accelerometers_agree = false;
  sequence.clear_guide().expect(Phase::launched, PhaseReason::launch_detected);
  sequence.next.accelerometers_agree = true;
  sequence.tick();
  sequence.expect(Phase::controlling, PhaseReason::guide_clear);
  sequence.next.accelerometers_agree = false;  // later nobody asks
  EXPECT_FALSE(sequence.tick());
}

TEST(FlightPhase, GuideThatIsNotClearedInTimeGoesBackToArmed) {
  Sequence sequence;
  sequence.arm().launch();
  for (int i = 1; i < 1'500; ++i) {
    ASSERT_FALSE(sequence.tick()) << i;
  }
  EXPECT_TRUE(sequence.tick());
  sequence.expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
}

TEST(FlightPhase, GuideIsNotClearWhileTheGyroIsSilent) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.motion.gyro = SensorState::lost;
  sequence.clear_guide().expect(Phase::launched, PhaseReason::launch_detected);
  sequence.next.motion.gyro = SensorState::coasting;
  sequence.tick();
  sequence.expect(Phase::controlling, PhaseReason::guide_clear);
}

TEST(FlightPhase, FaultBeforeControlGoesBackToThePad) {
  Sequence gyro;
  gyro.arm().launch();
  gyro.tick([](Tick& i) { i.motion.gyro = SensorState::lost; });
  gyro.expect(Phase::launched, PhaseReason::launch_detected);
  gyro.tick([](Tick& i) { i.motion.gyro = SensorState::failed; });
  gyro.expect(Phase::armed, PhaseReason::gyro_failed_before_control);
  EXPECT_FALSE(gyro.phases().listens_for_launch());

  Sequence timing;
  timing.arm().launch();
  timing.tick([](Tick& i) { i.timing_fault = true; });
  timing.expect(Phase::armed, PhaseReason::timing_fault_before_control);
  EXPECT_FALSE(timing.phases().listens_for_launch());
}

TEST(FlightPhase, ControlEndsWhenItsTimeIsOver) {
  FlightPlan plan = default_plan();
  plan.run.control_time = ms(500);
  Sequence sequence{plan};
  sequence.arm().launch().clear_guide();
  for (int i = 1; i < 500; ++i) {
    ASSERT_FALSE(sequence.tick()) << i;
  }
  EXPECT_TRUE(sequence.tick());
  sequence.expect(Phase::finished, PhaseReason::control_time_over);
}

struct End {
  PhaseReason reason;
  std::function<void(Tick&)> cause;
};

const End ends[] = {
    {PhaseReason::apogee, [](Tick& i) { i.motion.vertical_speed_m_s = -0.001F; }},
    {PhaseReason::tilted_too_far, [](Tick& i) { i.motion.tilt = 60.1_deg; }},
    {PhaseReason::gyro_failed, [](Tick& i) { i.motion.gyro = SensorState::failed; }},
    {PhaseReason::timing_fault, [](Tick& i) { i.timing_fault = true; }},
};

TEST(FlightPhase, ControlEndsForEachOfItsReasonsAndStaysEnded) {
  for (const End& end : ends) {
    Sequence sequence;
    sequence.arm().launch().clear_guide();
    sequence.next.motion.tilt = default_plan().run.tilt_limit;
    sequence.next.motion.gyro = SensorState::lost;
    sequence.next.motion.vertical_speed_m_s = 0.0F;
    EXPECT_FALSE(sequence.tick());
    EXPECT_TRUE(sequence.tick(end.cause));
    sequence.expect(Phase::finished, end.reason);

    sequence.next.launch_detected = sequence.next.arm_command = sequence.next.start_command = true;
    sequence.next.motion.at_rest_for = ms(100'000);
    for (int i = 0; i < 5'000; ++i) {
      sequence.next.arm_switch_closed = i % 100 < 50;
      ASSERT_FALSE(sequence.tick());
    }
    sequence.expect(Phase::finished, end.reason);
  }
}

TEST(FlightPhase, ASpeedThatIsALowerBoundIsNoSignOfApogee) {
  Sequence sequence;
  sequence.arm().launch().clear_guide();
  sequence.next.motion.vertical_speed_m_s = -1.0F;
  sequence.next.motion.speed_is_lower_bound = true;
  EXPECT_FALSE(sequence.tick());
  sequence.next.motion.speed_is_lower_bound = false;
  EXPECT_TRUE(sequence.tick());
  sequence.expect(Phase::finished, PhaseReason::apogee);
}

TEST(FlightPhase, CanardFaultEndsControlOnlyWhenThePlanSaysSo) {
  for (const CanardFaultPolicy policy : {CanardFaultPolicy::continue_control, CanardFaultPolicy::end_control}) {
    FlightPlan plan = default_plan();
    plan.run.canard_fault = policy;
    Sequence sequence{plan};
    sequence.arm().launch().clear_guide();
    EXPECT_FALSE(sequence.tick());
    sequence.next.canard_fault = true;
    EXPECT_EQ(sequence.tick(), policy == CanardFaultPolicy::end_control);
    if (policy == CanardFaultPolicy::end_control) {
      sequence.expect(Phase::finished, PhaseReason::canard_fault);
    }
  }
}

TEST(FlightPhase, TunnelStartsOnCommandOnlyArmedAndAtRest) {
  Sequence safe{tunnel_plan()};
  safe.start_tunnel().expect(Phase::safe, PhaseReason::power_on);

  Sequence moving{tunnel_plan()};
  moving.arm();
  moving.next.motion.at_rest_for = ms(1'999);
  moving.tick([](Tick& i) { i.start_command = true; });
  moving.expect(Phase::armed, PhaseReason::armed_by_switch_and_command);

  Sequence ready{tunnel_plan()};
  ready.arm();
  ready.next.motion.at_rest_for = ms(5'000);
  EXPECT_FALSE(ready.tick());
  ready.start_tunnel().expect(Phase::controlling, PhaseReason::tunnel_start_command);
  EXPECT_EQ(ready.phases().control_start(), ready.next.time);
}

TEST(FlightPhase, TunnelDoesNotStartInATickOfATimingFault) {
  Sequence sequence{tunnel_plan()};
  sequence.arm();
  sequence.next.motion.at_rest_for = ms(5'000);
  EXPECT_FALSE(sequence.tick([](Tick& i) { i.start_command = i.timing_fault = true; }));
}

TEST(FlightPhase, TunnelKnowsNoLaunchNoApogeeAndNoTilt) {
  Sequence sequence{tunnel_plan()};
  sequence.arm();
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  sequence.launch().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
  sequence.start_tunnel();
  sequence.next.motion.vertical_speed_m_s = -5.0F;
  sequence.next.motion.tilt = 89_deg;
  EXPECT_FALSE(sequence.tick());
  sequence.tick([](Tick& i) { i.motion.gyro = SensorState::failed; });
  sequence.expect(Phase::finished, PhaseReason::gyro_failed);
}

TEST(FlightPhase, WhatNoInputSaysHasNotHappened) {
  FlightPlan plan = default_plan();
  plan.run.canard_fault = CanardFaultPolicy::end_control;
  FlightPhase safe{plan.run, plan.guide, plan.motion};
  Motion still;
  still.gyro = SensorState::fresh;
  still.at_rest_for = plan.motion.rest_time;
  EXPECT_FALSE(safe.update({.arm_command = true}, still)) << "by a switch";
  EXPECT_FALSE(safe.update({.arm_switch_closed = true}, still)) << "by a command";

  FlightPhase flown = safe;
  ASSERT_TRUE(flown.update({.arm_switch_closed = true, .arm_command = true}, still));
  EXPECT_FALSE(flown.update({.arm_switch_closed = true}, still)) << "by a launch";
  ASSERT_TRUE(flown.update({.arm_switch_closed = true, .launch_detected = true}, still));
  EXPECT_FALSE(flown.update({}, still)) << "by a timing fault";
  Motion fast = still;
  fast.distance_along_guide_m = fast.speed_m_s = 100.0F;
  ASSERT_TRUE(flown.update({}, fast));
  EXPECT_FALSE(flown.update({}, fast)) << "by a fault of a canard";

  const FlightPlan in_tunnel = tunnel_plan();
  FlightPhase tunnel{in_tunnel.run, in_tunnel.guide, in_tunnel.motion};
  ASSERT_TRUE(tunnel.update({.arm_switch_closed = true, .arm_command = true}, still));
  EXPECT_FALSE(tunnel.update({.arm_switch_closed = true}, still)) << "by a start";
}

TEST(FlightPhase, LaunchPlanDoesNotStartOnTheTunnelsCommand) {
  Sequence sequence;
  sequence.arm();
  sequence.start_tunnel().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

}  // namespace
}  // namespace fantail::core
