// SPDX-License-Identifier: MIT
// What a refused step of arming leaves as it is.
#include <gtest/gtest.h>

#include "avionics/board_rig.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;

TEST(Arming, ARefusedBeginLeavesTheNonceThatWasGivenBefore) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  rig.hardware.arm_switch_closed = false;
  rig.tick();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::switch_open);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->nonce, nonce);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  rig.pc.say(ArmAction::confirm, nonce);
  EXPECT_EQ(rig.tick().phase, Phase::armed);
}

TEST(Arming, ARefusedStartDoesNotTakeBackOneThatWasAcceptedInTheSameTick) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  BoardRig rig{plan};
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.pc.say(ArmAction::start, rig.armed_with);
  rig.pc.say(ArmAction::start, rig.armed_with + 1);
  EXPECT_EQ(rig.tick().phase, Phase::controlling);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::wrong_nonce);
}

}  // namespace
}  // namespace fantail::avionics
