// SPDX-License-Identifier: MIT

#include "avionics/arming.hpp"
#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// The steps of arming without a board around them.

using core::Microseconds;
using protocol::ArmAction;
using protocol::ArmRefusal;

/// A rocket that may be armed, and who arms it.
struct Armed {
  Situation now{.time = Microseconds{10'000'000}, .at_rest = true, .arm_switch_closed = true};
  Arming::Permission permission{.self_test_passed = true, .power_up = 7, .random = 0x1234};
  Arming arming;

  Armed() {
    now.arm_switch_closed = false;
    now.arm_switch_open = true;
    arming.update(now);
    now.arm_switch_closed = true;
    now.arm_switch_open = false;
    arming.update(now);
  }
  ArmRefusal say(ArmAction action, std::uint32_t nonce = 0) {
    arming.receive(now, permission, {.action = action, .nonce = nonce});
    return arming.refusal();
  }
  std::uint32_t begin() {
    EXPECT_EQ(say(ArmAction::begin), ArmRefusal::none);
    return arming.nonce().value();
  }
};

TEST(ArmingAlone, ASelfTestIsNoneOfItsSteps) {
  Armed rocket;
  const std::uint32_t nonce = rocket.begin();
  rocket.arming.answer(ArmRefusal::board_fault);
  EXPECT_EQ(rocket.say(ArmAction::self_test), ArmRefusal::board_fault) << "the answer stays";
  EXPECT_EQ(rocket.arming.nonce(), nonce);
  EXPECT_FALSE(rocket.arming.take_arm_command());
}

TEST(ArmingAlone, TheCommandIsGivenOnce) {
  Armed rocket;
  EXPECT_EQ(rocket.say(ArmAction::confirm, rocket.begin()), ArmRefusal::none);
  EXPECT_TRUE(rocket.arming.take_arm_command());
  EXPECT_FALSE(rocket.arming.take_arm_command());
  EXPECT_FALSE(rocket.arming.take_start_command());
}

TEST(ArmingAlone, EachObjectionStopsBothSteps) {
  const auto refused = [](auto change, ArmRefusal expected) {
    Armed at_begin;
    change(at_begin);
    EXPECT_EQ(at_begin.say(ArmAction::begin), expected);
    EXPECT_FALSE(at_begin.arming.nonce());
    Armed at_confirm;
    const std::uint32_t nonce = at_confirm.begin();
    change(at_confirm);
    EXPECT_EQ(at_confirm.say(ArmAction::confirm, nonce), expected);
    EXPECT_FALSE(at_confirm.arming.take_arm_command());
    EXPECT_FALSE(at_confirm.arming.nonce()) << "one attempt";
  };
  refused([](Armed& r) { r.now.phase = core::Phase::armed; }, ArmRefusal::not_safe);
  refused([](Armed& r) { r.permission.session_open = true; }, ArmRefusal::session_open);
  refused([](Armed& r) { r.now.board_faulty = true; }, ArmRefusal::board_fault);
  refused([](Armed& r) { r.permission.self_test_passed = false; }, ArmRefusal::self_test_not_passed);
  refused([](Armed& r) { r.now.at_rest = false; }, ArmRefusal::not_at_rest);
  refused([](Armed& r) { r.now.arm_switch_closed = false; }, ArmRefusal::switch_open);
  refused([](Armed& r) { r.now.abort = protocol::AbortState::asks_to_abort; }, ArmRefusal::abort_not_ready);
  refused([](Armed& r) { r.now.abort = protocol::AbortState::unsettled; }, ArmRefusal::abort_not_ready);
}

TEST(ArmingAlone, ASwitchThatWasNeverSeenOpenDoesNotArm) {
  Armed rocket;
  rocket.arming = {};
  rocket.arming.update(rocket.now);
  EXPECT_EQ(rocket.say(ArmAction::begin), ArmRefusal::switch_not_cycled);
}

TEST(ArmingAlone, ANonceLivesFiveSecondsToTheMicrosecond) {
  for (const bool in_time : {true, false}) {
    Armed rocket;
    const std::uint32_t nonce = rocket.begin();
    rocket.now.time += Microseconds{in_time ? 5'000'000 : 5'000'001};
    rocket.arming.update(rocket.now);
    EXPECT_EQ(rocket.arming.nonce().has_value(), in_time);
    EXPECT_EQ(rocket.arming.refusal(), in_time ? ArmRefusal::none : ArmRefusal::nonce_expired);
    EXPECT_EQ(rocket.say(ArmAction::confirm, nonce), in_time ? ArmRefusal::none : ArmRefusal::nonce_expired);
    EXPECT_EQ(rocket.say(ArmAction::confirm, nonce), ArmRefusal::no_nonce) << "a second attempt has nothing to confirm";
  }
}

TEST(ArmingAlone, AConfirmationThatComesTooLateIsRefusedAlsoBeforeTheTickHasSeenTheTime) {
  Armed rocket;
  const std::uint32_t nonce = rocket.begin();
  rocket.now.time += Arming::nonce_lifetime + Microseconds{1};
  EXPECT_EQ(rocket.say(ArmAction::confirm, nonce), ArmRefusal::nonce_expired);
  EXPECT_FALSE(rocket.arming.take_arm_command());
}

TEST(ArmingAlone, WhereNobodyHasBegunThereIsNothingToConfirm) {
  Armed rocket;
  EXPECT_EQ(rocket.arming.refusal(), ArmRefusal::none);
  EXPECT_EQ(rocket.say(ArmAction::confirm), ArmRefusal::no_nonce);
}

TEST(ArmingAlone, WhatAPermissionDoesNotSayIsNotPermitted) {
  Armed untested;
  untested.permission = {.power_up = 7};
  EXPECT_EQ(untested.say(ArmAction::begin), ArmRefusal::self_test_not_passed);
  Armed uncounted;
  uncounted.permission = {.self_test_passed = true};
  EXPECT_EQ(uncounted.say(ArmAction::begin), ArmRefusal::no_nonce);
  EXPECT_EQ(uncounted.say(ArmAction::start), ArmRefusal::not_a_tunnel_plan);
  Armed without_a_random_number;
  without_a_random_number.permission = {.self_test_passed = true, .power_up = 7};
  EXPECT_EQ(without_a_random_number.begin(), 0xBC74651FU) << "see the finisher below";
}

TEST(ArmingAlone, ANewNonceTakesTheReproachOfTheOldOneAway) {
  Armed rocket;
  rocket.begin();
  rocket.now.time += 2 * Arming::nonce_lifetime;
  const std::uint32_t second = rocket.begin();
  EXPECT_EQ(rocket.say(ArmAction::confirm, second + 1), ArmRefusal::wrong_nonce);
  EXPECT_EQ(rocket.say(ArmAction::confirm, second), ArmRefusal::no_nonce);
}

TEST(ArmingAlone, OfOnePowerUpNoNonceIsGivenTwiceAndTheyEnd) {
  Armed rocket;
  std::set<std::uint32_t> nonces;
  std::size_t given = 0;
  while (given < 100'000 && rocket.say(ArmAction::begin) == ArmRefusal::none) {
    nonces.insert(rocket.arming.nonce().value());
    given += 1;
  }
  EXPECT_EQ(given, 65'535U) << "as many as 16 bits count";
  EXPECT_EQ(nonces.size(), given);
  EXPECT_EQ(rocket.arming.refusal(), ArmRefusal::no_nonce);
}

TEST(ArmingAlone, WithoutACountOfThePowerUpThereIsNoNonce) {
  Armed rocket;
  rocket.permission.power_up.reset();
  EXPECT_EQ(rocket.say(ArmAction::begin), ArmRefusal::no_nonce);
}

TEST(ArmingAlone, ANonceIsMurmursFinisherOfPowerUpAndRequestWithTheRandomNumberOnTop) {
  // MurmurHash3's fmix32 of 0x00070001 and of 0x00070002, computed in Python.
  Armed rocket;
  rocket.permission.random = 0;
  EXPECT_EQ(rocket.begin(), 0xBC74651FU);
  rocket.permission.random = 0xFFFF0000;
  EXPECT_EQ(rocket.begin(), 0x7C508418U ^ 0xFFFF0000U);
}

TEST(ArmingAlone, InTheTunnelAStartTakesAnArmedRocketAtRestAndTheNonceThatArmed) {
  Armed rocket;
  rocket.permission.tunnel_plan = true;
  rocket.now.phase = core::Phase::armed;
  EXPECT_EQ(rocket.say(ArmAction::start, 0), ArmRefusal::not_armed) << "armed, but by nobody that this object knows";
  rocket.now.phase = core::Phase::safe;
  const std::uint32_t nonce = rocket.begin();
  ASSERT_EQ(rocket.say(ArmAction::confirm, nonce), ArmRefusal::none);
  EXPECT_EQ(rocket.say(ArmAction::start, nonce), ArmRefusal::not_armed);
  rocket.now.phase = core::Phase::armed;
  EXPECT_EQ(rocket.say(ArmAction::start, nonce + 1), ArmRefusal::wrong_nonce);
  rocket.now.at_rest = false;
  EXPECT_EQ(rocket.say(ArmAction::start, nonce), ArmRefusal::not_at_rest);
  rocket.now.at_rest = true;
  rocket.permission.tunnel_plan = false;
  EXPECT_EQ(rocket.say(ArmAction::start, nonce), ArmRefusal::not_a_tunnel_plan);
  EXPECT_FALSE(rocket.arming.take_start_command());
  rocket.permission.tunnel_plan = true;
  EXPECT_EQ(rocket.say(ArmAction::start, nonce), ArmRefusal::none);
  EXPECT_TRUE(rocket.arming.take_start_command());
  EXPECT_FALSE(rocket.arming.take_start_command());
}

// What a refused step of arming leaves as it is.

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
