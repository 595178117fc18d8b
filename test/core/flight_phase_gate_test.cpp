// SPDX-License-Identifier: MIT
#include "core/flight_phase.hpp"
#include "phase_sequence.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

/// Beyond the guide, in flight, with the gate as it is said.
Sequence flown(bool gate_is_open, const FlightPlan& plan = default_plan()) {
  Sequence sequence{plan};
  sequence.next.gate_is_open = gate_is_open;
  sequence.arm().launch().clear_guide();
  return sequence;
}

void run(Sequence& sequence, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    sequence.tick();
  }
}

TEST(GatedFlight, BehindAClosedGateIsDormantUntilItOpens) {
  Sequence sequence = flown(false);
  sequence.expect(Phase::dormant, PhaseReason::guide_clear);
  EXPECT_FALSE(sequence.phases().control_start());
  run(sequence, 10'000);
  sequence.expect(Phase::dormant, PhaseReason::guide_clear);
  sequence.next.gate_is_open = true;
  EXPECT_TRUE(sequence.tick());
  sequence.expect(Phase::controlling, PhaseReason::gate_open);
  EXPECT_EQ(sequence.phases().control_start(), sequence.next.time);
}

TEST(GatedFlight, AGateThatIsOpenBeforeTheGuideIsClearOpensNothing) {
  Sequence sequence;
  sequence.next.gate_is_open = true;
  sequence.arm().launch();
  run(sequence, 1'000);
  sequence.expect(Phase::launched, PhaseReason::launch_detected);
}

TEST(GatedFlight, AGateThatOpensWhileTheGyroIsSilentWaitsForIt) {
  Sequence sequence = flown(false);
  sequence.next.gate_is_open = true;
  sequence.next.motion.gyro = SensorState::lost;
  run(sequence, 100);
  sequence.expect(Phase::dormant, PhaseReason::guide_clear);
  sequence.next.motion.gyro = SensorState::fresh;
  sequence.tick();
  sequence.expect(Phase::controlling, PhaseReason::gate_open);
}

TEST(GatedFlight, AGateThatIsNeverReachedEndsAtApogeeWithoutControl) {
  Sequence sequence = flown(false);
  sequence.next.motion.vertical_speed_m_s = -0.1F;
  sequence.next.gate_is_open = true;  // in the same tick it is too late
  sequence.tick();
  sequence.expect(Phase::finished, PhaseReason::gate_never_opened);
  EXPECT_FALSE(sequence.phases().control_start());
}

TEST(GatedFlight, WhereNobodySeesApogeeDormancyEndsAfterTwoMinutes) {
  Sequence sequence = flown(false);
  sequence.next.motion.vertical_speed_m_s = -50.0F;
  sequence.next.motion.speed_is_lower_bound = true;
  run(sequence, 119'999);
  sequence.expect(Phase::dormant, PhaseReason::guide_clear);
  sequence.tick();
  sequence.expect(Phase::finished, PhaseReason::gate_never_opened);
}

struct EndOfDormancy {
  PhaseReason reason;
  std::function<void(Tick&)> cause;
};

const EndOfDormancy ends_of_dormancy[] = {
    {PhaseReason::tilted_too_far, [](Tick& i) { i.motion.tilt = 60.1_deg; }},
    {PhaseReason::gyro_failed, [](Tick& i) { i.motion.gyro = SensorState::failed; }},
    {PhaseReason::timing_fault, [](Tick& i) { i.timing_fault = true; }},
    {PhaseReason::canard_fault, [](Tick& i) { i.canard_fault = true; }},
    {PhaseReason::aborted, [](Tick& i) { i.abort = true; }},
};

TEST(GatedFlight, DormancyEndsForWhatEndsControlEvenAsTheGateOpens) {
  FlightPlan plan = default_plan();
  plan.run.canard_fault = CanardFaultPolicy::end_control;
  for (const EndOfDormancy& end : ends_of_dormancy) {
    Sequence sequence = flown(false, plan);
    sequence.next.gate_is_open = true;
    EXPECT_TRUE(sequence.tick(end.cause));
    sequence.expect(Phase::finished, end.reason);
    run(sequence, 1'000);
    sequence.expect(Phase::finished, end.reason);
  }
}

TEST(GatedFlight, AGateThatClosesAgainBringsTheCanardsToTrimAndItsNextOpeningGoesOn) {
  Sequence sequence = flown(true);
  sequence.expect(Phase::controlling, PhaseReason::guide_clear);
  const auto start = sequence.phases().control_start();
  run(sequence, 100);
  sequence.next.gate_is_open = false;
  sequence.tick();
  sequence.expect(Phase::dormant, PhaseReason::gate_closed_again);
  run(sequence, 100);
  sequence.next.gate_is_open = true;
  sequence.tick();
  sequence.expect(Phase::controlling, PhaseReason::gate_open);
  EXPECT_EQ(sequence.phases().control_start(), start) << "the time of reference and control has gone on";
}

TEST(GatedFlight, ControlThatHasBegunEndsBehindAClosedGateAsItDoesBeforeAnOpenOne) {
  FlightPlan plan = default_plan();
  plan.run.control_time = ms(500);
  Sequence timed = flown(true, plan);
  timed.next.gate_is_open = false;
  run(timed, 499);
  timed.expect(Phase::dormant, PhaseReason::gate_closed_again);
  timed.next.gate_is_open = true;  // not for a tick of control more
  timed.tick();
  timed.expect(Phase::finished, PhaseReason::control_time_over);

  Sequence falling = flown(true);
  falling.next.gate_is_open = false;
  falling.tick();
  falling.next.motion.vertical_speed_m_s = -0.1F;
  falling.tick();
  falling.expect(Phase::finished, PhaseReason::apogee);
}

TEST(GatedFlight, ItsMemoryIsGivenUpAsThatOfAnyFlight) {
  FlightPhase phases{default_plan().run, default_plan().guide, default_plan().motion};
  Motion motion;
  motion.gyro = SensorState::fresh;
  motion.distance_along_guide_m = motion.speed_m_s = 100.0F;
  phases.update({.arm_switch_closed = true, .arm_command = true}, motion);
  phases.update({.arm_switch_closed = true, .launch_detected = true}, motion);
  phases.update({.gate_is_open = false}, motion);
  ASSERT_EQ(phases.phase(), Phase::dormant);
  phases.give_up(ms(1));
  EXPECT_EQ(phases.phase(), Phase::finished);
  EXPECT_EQ(phases.reason(), PhaseReason::memory_fault);
}

TEST(Abort, NothingIsArmedWhileItIsAskedFor) {
  Sequence sequence;
  sequence.next.abort = true;
  sequence.arm().expect(Phase::safe, PhaseReason::power_on);
  sequence.next.abort = false;
  sequence.arm().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

TEST(Abort, DisarmsOnThePadEvenInTheTickOfADetection) {
  Sequence sequence;
  sequence.arm();
  sequence.tick([](Tick& i) { i.abort = i.launch_detected = true; });
  sequence.expect(Phase::safe, PhaseReason::aborted);
}

// A contact that chatters has asked for it once, and that is enough.
TEST(Abort, EndsAFlightForGoodInEachOfItsPhases) {
  for (const Phase phase : {Phase::launched, Phase::dormant, Phase::controlling}) {
    Sequence sequence;
    sequence.next.gate_is_open = phase == Phase::controlling;
    sequence.arm().launch();
    if (phase != Phase::launched) {
      sequence.clear_guide();
    }
    ASSERT_EQ(sequence.phases().phase(), phase);
    sequence.tick([](Tick& i) { i.abort = true; });
    sequence.expect(Phase::finished, PhaseReason::aborted);
    sequence.next.gate_is_open = true;
    sequence.clear_guide();
    sequence.expect(Phase::finished, PhaseReason::aborted);
  }
}

TEST(TiltLimit, IsCountedFromTheGuideWhereThatIsMeasured) {
  Sequence sequence = flown(true);
  sequence.next.motion.tilt = 70_deg;
  sequence.next.motion.tilt_from_guide = 59_deg;
  EXPECT_FALSE(sequence.tick());
  sequence.next.motion.tilt = 50_deg;
  sequence.next.motion.tilt_from_guide = 60.1_deg;
  sequence.tick();
  sequence.expect(Phase::finished, PhaseReason::tilted_too_far);
}

}  // namespace
}  // namespace fantail::core
