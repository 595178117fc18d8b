// SPDX-License-Identifier: MIT
// The abort input from its contact to the servos and the bus. Its contacts do not bounce here: see test/sim.

#include "avionics/flying_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::AbortInput;
using core::Phase;
using core::PhaseReason;
using protocol::AbortState;
using protocol::ArmRefusal;
using protocol::ArmReply;

core::FlightPlan plan_with(AbortInput input) {
  core::FlightPlan plan = core::default_plan();
  plan.run.abort_input = input;
  return plan;
}

/// The level at which a healthy contact of that sense stands.
constexpr bool healthy(AbortInput input) { return input == AbortInput::open_aborts; }

struct AbortRig : FlyingRig {
  explicit AbortRig(AbortInput input) : FlyingRig{plan_with(input)}, healthy_{healthy(input)} { press(false); }
  void press(bool pressed) { hardware.abort_contact_closed = healthy_ != pressed; }
  [[nodiscard]] AbortState told() {
    run(100 * millisecond);  // the period of its report
    return pc.heard<ArmReply>()->abort_input;
  }

 private:
  bool healthy_;
};

constexpr std::array fitted{AbortInput::open_aborts, AbortInput::closed_aborts};

TEST(AbortInput, WhileItAsksItRefusesArmingByNameAtBothSteps) {
  for (const AbortInput input : fitted) {
    AbortRig rig{input};
    rig.press(true);
    EXPECT_FALSE(rig.begin_arming());
    EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::abort_not_ready);
    rig.press(false);
    const std::uint32_t nonce = rig.begin_arming().value();
    rig.press(true);
    rig.tick();
    rig.pc.say(protocol::ArmAction::confirm, nonce);
    EXPECT_EQ(rig.tick().phase, Phase::safe);
    EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::abort_not_ready);
  }
}

TEST(AbortInput, InArmedMakesTheRocketSafe) {
  for (const AbortInput input : fitted) {
    AbortRig rig{input};
    ASSERT_EQ(rig.arm().phase, Phase::armed);
    rig.press(true);
    const core::TickRecord& record = rig.tick();
    EXPECT_EQ(record.phase, Phase::safe);
    EXPECT_EQ(record.reason, PhaseReason::aborted);
  }
}

TEST(AbortInput, InAControlledFlightPutsTheCanardsToTrimInTheSameTick) {
  for (const AbortInput input : fitted) {
    AbortRig rig{input};
    rig.launch_to_control();
    rig.fly_for(100 * millisecond);
    ASSERT_FALSE(rig.all_pulses_are(0.0)) << "the fins stand askew";
    rig.press(true);
    EXPECT_EQ(rig.fly().phase, Phase::finished);
    EXPECT_TRUE(rig.all_pulses_are(0.0));
    rig.press(false);
    const core::TickRecord* record = rig.fly_for(second);
    EXPECT_EQ(record->phase, Phase::finished);
    EXPECT_EQ(record->reason, PhaseReason::aborted);
    EXPECT_TRUE(rig.all_pulses_are(0.0));
    EXPECT_EQ(rig.pc.heard<protocol::StatusReport>()->reason, PhaseReason::aborted);
  }
}

TEST(AbortInput, ThatThePlanDoesNotHaveChangesNothingAtEitherLevel) {
  AbortRig rig{AbortInput::none};
  rig.hardware.abort_contact_closed = true;
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.hardware.abort_contact_closed = false;
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_EQ(rig.told(), AbortState::none_fitted);
}

TEST(AbortInput, IsReportedAsItStands) {
  for (const AbortInput input : fitted) {
    AbortRig rig{input};
    EXPECT_EQ(rig.told(), AbortState::ready);
    EXPECT_FALSE(rig.pc.heard<protocol::StatusReport>()->abort);
    rig.press(true);
    EXPECT_EQ(rig.told(), AbortState::asks_to_abort);
    EXPECT_TRUE(rig.pc.heard<protocol::StatusReport>()->abort);
  }
}

}  // namespace
}  // namespace fantail::avionics
