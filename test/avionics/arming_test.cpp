// SPDX-License-Identifier: MIT

#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;

Phase phase_after(BoardRig& rig, ArmAction action, std::uint32_t nonce = 0) {
  rig.pc.say(action, nonce);
  return rig.tick().phase;
}

TEST(Arming, TakesTheSwitchAndBothStepsOfTheCommand) {
  BoardRig rig;
  EXPECT_EQ(rig.arm().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<protocol::StatusReport>()->reason, core::PhaseReason::power_on);
  rig.run(10 * millisecond);
  EXPECT_EQ(rig.pc.heard<protocol::StatusReport>()->reason, core::PhaseReason::armed_by_switch_and_command);
}

TEST(Arming, TheSwitchAloneDoesNothing) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  rig.hardware.arm_switch_closed = true;
  EXPECT_EQ(rig.run(10 * second)->phase, Phase::safe);
}

TEST(Arming, TheCommandAloneIsRefusedBecauseTheSwitchIsOpen) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  EXPECT_EQ(phase_after(rig, ArmAction::begin), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::switch_open);
  EXPECT_FALSE(rig.pc.heard<ArmReply>()->nonce);
}

TEST(Arming, ASwitchThatOpensBeforeTheConfirmationPreventsIt) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  rig.hardware.arm_switch_closed = false;
  rig.tick();
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::switch_open);
}

TEST(Arming, WithoutASelfTestItIsRefused) {
  BoardRig rig;
  rig.run(3 * second);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  EXPECT_EQ(phase_after(rig, ArmAction::begin), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
}

TEST(Arming, ASelfTestIsGoodForAMinute) {
  for (const bool in_time : {true, false}) {
    BoardRig rig;
    rig.pc.say(ArmAction::self_test);
    while (rig.pc.heard<ArmReply>().value_or(ArmReply{}).self_test != SelfTestState::passed) {
      rig.tick();
    }
    rig.run((in_time ? 59 : 61) * second);
    rig.hardware.arm_switch_closed = true;
    rig.tick();
    rig.pc.say(ArmAction::begin);
    rig.tick();
    EXPECT_EQ(rig.pc.heard<ArmReply>()->nonce.has_value(), in_time);
  }
}

TEST(Arming, ARocketThatWasMovedAfterItsSelfTestNeedsAnother) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(100 * millisecond);
  rig.hardware.imu.rate = {};
  rig.run(5 * second);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, protocol::SelfTestFailure::moved);
}

TEST(Arming, ARocketThatWasMovedWhileArmedNeedsAnotherSelfTestToo) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(100 * millisecond);
  rig.hardware.imu.rate = {};
  rig.run(3 * second);  // it stands again before anybody opens the switch
  rig.hardware.arm_switch_closed = false;
  ASSERT_EQ(rig.run(5 * second)->phase, Phase::safe);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::not_run) << "no test has failed";
}

TEST(Arming, ANonceExpiresAfterFiveSeconds) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  rig.run(5 * second - millisecond);
  ASSERT_TRUE(rig.pc.heard<ArmReply>()->nonce);
  rig.run(2 * millisecond);
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::nonce_expired);
}

TEST(Arming, AtTheLastMomentANonceStillArms) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  rig.run(5 * second - millisecond);
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::armed);
}

TEST(Arming, AWrongNonceVoidsTheRightOne) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce ^ 1U), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::wrong_nonce);
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::no_nonce);
}

TEST(Arming, AConfirmationOutOfNothingIsRefused) {
  BoardRig rig;
  ASSERT_TRUE(rig.begin_arming());
  rig.power_cycle();
  rig.hardware.arm_switch_closed = false;
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, 0), Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::no_nonce);
}

TEST(Arming, AfterAResetWithTheSwitchClosedEverythingHasToBeDoneAgain) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.power_cycle();
  EXPECT_EQ(rig.run(8 * second)->phase, Phase::safe);
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  rig.pc.say(ArmAction::begin);
  EXPECT_EQ(rig.tick().phase, Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::switch_not_cycled);
  rig.hardware.arm_switch_closed = false;
  rig.tick();
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, rig.pc.heard<ArmReply>()->nonce.value()), Phase::armed);
}

// Everything that the PC said, millisecond by millisecond, and the same hand on the switch.
TEST(Arming, TheFramesOfAnEarlierPowerUpDoNotArm) {
  BoardRig rig;
  hal::sim::CanBus tap{rig.wire};
  std::vector<std::pair<Microseconds, hal::CanFrame>> recorded;
  const auto record = [&] {
    while (const auto frame = tap.receive()) {
      if (frame->id < 0x100) {
        recorded.emplace_back(rig.hardware.time, *frame);
      }
    }
  };
  rig.pc.say(ArmAction::self_test);
  record();
  rig.run(8 * second);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  while (tap.receive()) {
  }
  rig.pc.say(ArmAction::begin);
  record();
  rig.tick();
  rig.pc.say(ArmAction::confirm, rig.pc.heard<ArmReply>()->nonce.value());
  record();
  ASSERT_EQ(rig.tick().phase, Phase::armed);
  ASSERT_EQ(recorded.size(), 3U);

  rig.hardware.arm_switch_closed = false;
  rig.power_cycle();
  Phase highest = Phase::safe;
  std::size_t next = 0;
  while (rig.hardware.time < 9 * second) {
    for (; next < recorded.size() && recorded[next].first == rig.hardware.time; ++next) {
      (void)rig.pc.bus.send(recorded[next].second);
    }
    rig.hardware.arm_switch_closed = rig.hardware.time >= 8 * second;
    highest = std::max(highest, rig.tick().phase);
  }
  EXPECT_EQ(next, 3U);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::wrong_nonce);
  EXPECT_EQ(highest, Phase::safe);
}

TEST(Arming, NoTwoNoncesOfTenPowerUpsAreEqual) {
  BoardRig rig;
  std::vector<std::uint32_t> seen;
  for (int power_up = 0; power_up < 10; ++power_up) {
    rig.hardware.arm_switch_closed = false;
    rig.power_cycle();
    seen.push_back(rig.begin_arming().value());
    for (int i = 0; i < 20; ++i) {
      rig.pc.say(ArmAction::begin);
      rig.tick();
      seen.push_back(rig.pc.heard<ArmReply>()->nonce.value());
    }
  }
  std::ranges::sort(seen);
  EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
}

// Both count their first power-up as number one.
TEST(Arming, TwoBoardsWithBlankFlashHaveDifferentNonces) {
  BoardRig one;
  BoardRig other;
  one.entropy.number = 0x12345678;
  other.entropy.number = 0x12345679;
  EXPECT_NE(one.begin_arming().value(), other.begin_arming().value());
}

TEST(Arming, AnOpenBenchSessionPreventsIt) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(8 * second);
  rig.hardware.arm_switch_closed = true;
  rig.open_session();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::session_open);
}

TEST(Arming, TheSwitchDisarmsAndTheNonceIsNotGoodForASecondTime) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  ASSERT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::armed);
  rig.hardware.arm_switch_closed = false;
  ASSERT_EQ(rig.tick().phase, Phase::safe);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  EXPECT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::safe);
}

core::FlightPlan tunnel_plan() {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  return plan;
}

TEST(Arming, InTheTunnelControlStartsWithTheNonceThatArmed) {
  BoardRig rig{tunnel_plan()};
  const std::uint32_t nonce = rig.begin_arming().value();
  ASSERT_EQ(phase_after(rig, ArmAction::start, nonce), Phase::safe) << "not armed yet";
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_armed);
  ASSERT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::armed);
  EXPECT_EQ(phase_after(rig, ArmAction::start, nonce + 1), Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::wrong_nonce);
  EXPECT_EQ(phase_after(rig, ArmAction::start, nonce), Phase::controlling);
}

TEST(Arming, ALaunchPlanIsNeverStartedByCommand) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  ASSERT_EQ(phase_after(rig, ArmAction::confirm, nonce), Phase::armed);
  EXPECT_EQ(phase_after(rig, ArmAction::start, nonce), Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_a_tunnel_plan);
}

}  // namespace
}  // namespace fantail::avionics
