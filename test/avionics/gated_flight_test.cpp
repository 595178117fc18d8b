// SPDX-License-Identifier: MIT
#include "control_memory.hpp"
#include "flying_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::AbortInput;
using core::Phase;
using core::PhaseReason;

core::FlightPlan plan_until_burn_out() {
  core::FlightPlan plan = core::default_plan();
  plan.dormancy.until = core::DormantUntil::burn_out;
  plan.dormancy.burn_time = 3 * second;
  return plan;
}

// The motor burns for three seconds, and the clock waits for a tenth more; lift-off is seen within 10 ms.
constexpr double opening_s = 3.3;

double since_lit_s(const FlyingRig& rig) { return 1e-6 * static_cast<double>((rig.true_time - *rig.lit).count()); }

TEST(BoardBehindAGate, GivesThePulsesOfTrimUntilTheMotorHasBurnt) {
  FlyingRig rig{plan_until_burn_out()};
  rig.launch();
  ASSERT_EQ(rig.fly_to(Phase::dormant)->phase, Phase::dormant);
  while (rig.fly().phase == Phase::dormant) {
    ASSERT_TRUE(rig.all_pulses_are(0.0));
    ASSERT_LT(since_lit_s(rig), 5.0);
  }
  EXPECT_NEAR(since_lit_s(rig), opening_s, 0.02);
  EXPECT_NE(rig.console.text.find("phase: controlling, gate_open\n"), std::string::npos) << rig.console.text;
}

TEST(BoardBehindAGate, AResetWhileDormantIsResumedDormantAndTheGateOpensInItsTime) {
  for (const int after_ms : {1, 500, 2'000, 2'600}) {
    FlyingRig rig{plan_until_burn_out()};
    rig.launch();
    rig.fly_to(Phase::dormant);
    rig.fly_for(after_ms * millisecond);
    rig.reset(hal::ResetCause::watchdog);
    const core::TickRecord& first = rig.fly();
    ASSERT_EQ(first.phase, Phase::dormant) << after_ms;
    EXPECT_EQ(first.reason, PhaseReason::guide_clear);
    EXPECT_FALSE(first.timing_fault);
    ASSERT_EQ(rig.fly_to(Phase::controlling)->reason, PhaseReason::gate_open);
    EXPECT_NEAR(since_lit_s(rig), opening_s, 0.05) << after_ms;  // the clock is off by the age of the seal, and the gap
  }
}

TEST(BoardBehindAGate, AGateThatWasOpenBeforeAResetIsOpenAfterIt) {
  FlyingRig rig{plan_until_burn_out()};
  rig.launch_to_control();
  rig.fly_for(50 * millisecond);
  rig.reset(hal::ResetCause::watchdog);
  EXPECT_EQ(rig.fly().phase, Phase::controlling);
  rig.fly_for(500 * millisecond);
  EXPECT_EQ(rig.fly().phase, Phase::controlling);
}

TEST(BoardBehindAGate, DamageOfADormantLawEndsTheFlightAtTrim) {
  FlyingRig rig{plan_until_burn_out()};
  rig.launch();
  ASSERT_EQ(rig.fly_to(Phase::dormant)->phase, Phase::dormant);
  rig.fly_for(100 * millisecond);
  const auto memory = law_in(rig.avionics()).flight_memory();
  const_cast<std::byte&>(memory[memory.size() / 2]) ^= std::byte{1};
  EXPECT_EQ(rig.fly().reason, PhaseReason::memory_fault);
  EXPECT_EQ(rig.fly_for(4 * second)->phase, Phase::finished);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

class AbortContact : public testing::TestWithParam<AbortInput> {
 protected:
  AbortContact() { set(false); }
  static core::FlightPlan plan() {
    core::FlightPlan plan = core::default_plan();
    plan.run.abort_input = GetParam();
    return plan;
  }
  /// As whoever holds the other end of the wire wants it.
  void set(bool abort) { rig.hardware.abort_contact_closed = abort == (GetParam() == AbortInput::closed_aborts); }

  FlyingRig rig{plan()};
};

TEST_P(AbortContact, KeepsTheRocketFromBeingArmedAndIsNamed) {
  set(true);
  EXPECT_NE(rig.arm().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<protocol::ArmReply>()->refusal, protocol::ArmRefusal::abort_not_ready);
  rig.run(100 * millisecond);
  EXPECT_TRUE(rig.pc.heard<protocol::StatusReport>()->abort);
}

TEST_P(AbortContact, DisarmsOnThePad) {
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  set(true);
  const core::TickRecord& record = rig.tick();
  EXPECT_EQ(record.phase, Phase::safe);
  EXPECT_EQ(record.reason, PhaseReason::aborted);
}

TEST_P(AbortContact, EndsControlAtTrimForGoodAndIsNamed) {
  rig.disturbance_rad = 0.05;
  rig.launch_to_control();
  rig.fly_for(second);
  ASSERT_FALSE(rig.all_pulses_are(0.0));
  set(true);
  EXPECT_EQ(rig.fly().reason, PhaseReason::aborted);
  EXPECT_TRUE(rig.all_pulses_are(0.0)) << "in the same tick";
  set(false);
  rig.fly_for(second);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_NE(rig.console.text.find("phase: finished, aborted\n"), std::string::npos) << rig.console.text;
}

INSTANTIATE_TEST_SUITE_P(EachSense, AbortContact, testing::Values(AbortInput::open_aborts, AbortInput::closed_aborts),
                         [](const auto& each) {
                           return each.param == AbortInput::open_aborts ? "OpenAborts" : "ClosedAborts";
                         });

TEST(NoAbortContact, AsksForNothing) {
  for (const bool closed : {true, false}) {
    FlyingRig rig;
    rig.hardware.abort_contact_closed = closed;
    EXPECT_EQ(rig.arm().phase, Phase::armed);
    EXPECT_FALSE(rig.pc.heard<protocol::StatusReport>()->abort);
  }
}

}  // namespace
}  // namespace fantail::avionics
