// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "avionics/arming.hpp"
#include "avionics/board_rig.hpp"

namespace fantail::avionics {
namespace {

// Bench session, self-test and arming, where they meet.

using namespace core::literals;
using core::Phase;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;
using protocol::SessionAction;
using protocol::SessionReason;

TEST(RightToMove, ASessionIsRefusedUntilTheRocketHasStoodForTheRestTime) {
  BoardRig rig;
  rig.run(1'900 * millisecond);  // of the default plan's 2 s
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_at_rest);
}

TEST(RightToMove, ASessionIsRefusedWhileTheSelfTestRuns) {
  BoardRig rig;
  rig.run(3 * second);
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::self_test_runs);
  rig.run(6 * second);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed) << "and the test goes on";
}

TEST(RightToMove, ANewSessionDoesNotGoOnWithWhatTheLastOneAskedFor) {
  BoardRig rig;
  rig.open_session(7);
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, 5_deg, 5_deg, 5_deg}});
  rig.run(second);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::close, .session = 7});
  rig.heartbeat.reset();
  rig.run(second);
  rig.open_session(8);
  rig.run(100 * millisecond);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(RightToMove, ASessionThatIsOpenedInTheTickOfTheConfirmationMovesNothing) {
  BoardRig rig;
  rig.pc.say(ArmAction::confirm, rig.begin_arming().value());
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, 5_deg, 5_deg, 5_deg}});
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_safe);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(RightToMove, ASelfTestThatIsAskedForInTheTickOfTheConfirmationDoesNotRun) {
  BoardRig rig;
  rig.pc.say(ArmAction::confirm, rig.begin_arming().value());
  rig.pc.say(ArmAction::self_test);
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::failed) << "it was not refused: it had begun";
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, protocol::SelfTestFailure::not_safe);
}

TEST(RightToMove, APlanWithALongRestTimeIsNotArmedBeforeIt) {
  core::FlightPlan plan = core::default_plan();
  plan.motion.rest_time = 10 * second;
  BoardRig rig{plan};
  rig.arm();  // eight seconds after power-up
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_at_rest);
}

TEST(RightToMove, ControlInTheTunnelDoesNotStartWhileTheRocketMoves) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  BoardRig rig{plan};
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(10 * millisecond);
  rig.pc.say(ArmAction::start, rig.armed_with);
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_at_rest);
}

TEST(RightToMove, ThereIsNoNonceBeforeThisPowerUpIsCounted) {
  Arming arming;
  const Situation open{.at_rest = true, .arm_switch_closed = false, .arm_switch_open = true};
  const Situation closed{.at_rest = true, .arm_switch_closed = true};
  arming.update(open);
  arming.receive(closed, {.self_test_passed = true, .power_up = {}}, {.action = ArmAction::begin});
  EXPECT_FALSE(arming.nonce());
  EXPECT_EQ(arming.refusal(), ArmRefusal::no_nonce);
  arming.receive(closed, {.self_test_passed = true, .power_up = 1}, {.action = ArmAction::begin});
  EXPECT_TRUE(arming.nonce());
}

}  // namespace
}  // namespace fantail::avionics
