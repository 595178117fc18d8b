// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "avionics/board_rig.hpp"
#include "avionics/plan_on_bus.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::PlanReply;
using protocol::SelfTestState;
using protocol::TransferFault;
using protocol::TransferState;

core::FlightPlan plan_with_trim() {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = 4_deg;
  return plan;
}

TransferFault answer_to_begin(BoardRig& rig) {
  rig.pc.say(protocol::PlanBegin{.size = 500, .block_crc = 1});
  rig.tick();
  return rig.pc.heard<PlanReply>()->fault;
}

TEST(NewPlan, IsRefusedWhileANonceWaitsForItsConfirmation) {
  BoardRig rig;
  rig.make_ready();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(answer_to_begin(rig), TransferFault::not_safe);
}

TEST(NewPlan, IsTheOneThatTheBenchReadsBack) {
  BoardRig rig;
  rig.run(3 * second);
  const auto checksum_read_back = [&rig] {
    rig.pc.say(protocol::LogRequest{
        .action = protocol::LogAction::plan, .tag = 5, .offset = protocol::plan_block_size - 4, .size = 4});
    rig.run(core::Microseconds{30'000});
    const auto& part = rig.pc.heard<protocol::LogData>();
    return part ? static_cast<std::uint32_t>(protocol::get<4>(part->bytes, 0)) : 0U;
  };
  EXPECT_EQ(checksum_read_back(), protocol::plan_crc(core::default_plan()));
  send_plan(rig, plan_with_trim());
  rig.run(second);
  EXPECT_EQ(checksum_read_back(), protocol::plan_crc(plan_with_trim()));
}

TEST(NewPlan, IsRefusedWhileTheSelfTestRuns) {
  BoardRig rig;
  rig.run(3 * second);  // at rest, so it is the self-test that is in the way
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  EXPECT_EQ(answer_to_begin(rig), TransferFault::not_safe);
}

TEST(NewPlan, ARocketIsNotArmedWhileOneIsBeingWritten) {
  BoardRig rig;
  rig.make_ready();
  rig.flash.set_stays_busy(true);
  send_plan(rig, plan_with_trim());
  ASSERT_EQ(rig.pc.heard<PlanReply>()->state, TransferState::writing);
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_FALSE(rig.pc.heard<ArmReply>()->nonce);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
}

TEST(NewPlan, WantsASelfTestOfItsOwnWithItsOwnTrims) {
  BoardRig rig;
  rig.make_ready();
  send_plan(rig, plan_with_trim());
  rig.run(second);
  ASSERT_EQ(rig.pc.heard<PlanReply>()->state, TransferState::stored);
  rig.run(3 * second);
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::not_run);
  rig.make_ready();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
}

TEST(NewPlan, TheHeartbeatNamesItFromThenOn) {
  BoardRig rig;
  rig.run(3 * second);
  send_plan(rig, plan_with_trim());
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<protocol::HeartbeatReport>()->plan_crc, protocol::plan_crc(plan_with_trim()));
}

}  // namespace
}  // namespace fantail::avionics
