// SPDX-License-Identifier: MIT
// What an armed rocket that has moved must do before it detects a launch.
#include <gtest/gtest.h>

#include "core/flight_phase.hpp"
#include "phase_sequence.hpp"

namespace fantail::core {
namespace {

using namespace literals;

TEST(FlightPhase, AfterAFailedGateNothingIsDetectedBeforeTwoSecondsAtRest) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.time += ms(1'500);
  sequence.tick();
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  sequence.launch().expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
  sequence.next.motion.at_rest_for = ms(1'999);
  sequence.launch().expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
  sequence.next.motion.at_rest_for = ms(2'000);
  sequence.tick();
  EXPECT_TRUE(sequence.phases().listens_for_launch());
  sequence.next.motion.at_rest_for = ms(0);
  sequence.launch().expect(Phase::launched, PhaseReason::launch_detected);
}

TEST(FlightPhase, AnArmedRocketThatMovesDetectsNothingBeforeItHasRested) {
  Sequence sequence;
  sequence.arm();
  EXPECT_FALSE(sequence.tick([](Tick& i) {
    i.motion.has_moved = true;
    i.launch_detected = true;
  })) << "not even in that tick";
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.launch().expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.next.motion.at_rest_for = ms(2'000);
  sequence.tick([](Tick& i) { i.motion.has_moved = true; });  // at rest, but its attitude is not known yet
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.tick([](Tick& i) { i.motion.tilt = 45.1_deg; });  // lies, or hangs
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  EXPECT_FALSE(sequence.tick());
  sequence.expect(Phase::armed, PhaseReason::rested);
  sequence.next.motion.at_rest_for = ms(0);
  sequence.launch().expect(Phase::launched, PhaseReason::launch_detected);
}

TEST(FlightPhase, AnArmedRocketThatFellIsFinishedAndASafeOneIsNot) {
  Sequence sequence;
  sequence.tick([](Tick& i) { i.motion.has_fallen = true; });
  sequence.expect(Phase::safe, PhaseReason::power_on);
  sequence.arm();
  EXPECT_TRUE(sequence.tick([](Tick& i) { i.motion.has_fallen = true; }));
  sequence.expect(Phase::finished, PhaseReason::flew_without_launch);
  Sequence in_hands;
  in_hands.arm();
  in_hands.tick([](Tick& i) {
    i.motion.has_fallen = true;
    i.arm_switch_closed = false;
  });
  in_hands.expect(Phase::safe, PhaseReason::disarmed_by_switch);
}

TEST(FlightPhase, MovementInTheTunnelIsNobodysBusiness) {
  FlightPlan plan = default_plan();
  plan.run.start = Start::tunnel;
  Sequence sequence{plan};
  sequence.arm();
  sequence.tick([](Tick& i) { i.motion.has_moved = i.motion.has_fallen = true; });
  sequence.expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

TEST(FlightPhase, DisarmingDoesNotExcuseFromTheRest) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.time += ms(1'500);
  sequence.tick();
  sequence.tick([](Tick& i) { i.arm_switch_closed = false; });
  sequence.arm().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  sequence.tick();
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
}

}  // namespace
}  // namespace fantail::core
