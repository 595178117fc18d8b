// SPDX-License-Identifier: MIT
// The steps of docs/can.md, "Arming", frame by frame, without a line of the bench.
#include <gtest/gtest.h>

#include "avionics/can_frame.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;

class ArmByManual : public testing::Test {
 protected:
  ArmByManual() { live(4'000); }

  void live(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      place.wait(millisecond);
      link.listen(place.now());
    }
  }
  ArmReply ask(ArmAction action, std::uint32_t nonce) {
    (void)place.bus().send(
        avionics::can_frame(encode(protocol::ArmRequest{.action = action, .nonce = nonce}, counter)));
    counter = (counter + 1U) & 0x0FU;
    live(110);
    return link.reported<ArmReply>("answer to arming");
  }
  std::uint32_t nonce_after_switch() {
    live(8'000);
    EXPECT_EQ(link.reported<ArmReply>("answer to arming").self_test, SelfTestState::passed);
    place.world->set_arm_switch(true);
    live(100);  // until the contact has settled
    const ArmReply reply = ask(ArmAction::begin, 0xFFFFFFFF);
    EXPECT_TRUE(reply.nonce);
    return reply.nonce.value_or(0);
  }

  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  std::uint8_t counter = 14;
};

TEST_F(ArmByManual, WithAnyNonceWhereNoneIsAskedForTheRocketIsArmed) {
  EXPECT_EQ(ask(ArmAction::self_test, 0x12345678).self_test, SelfTestState::running);
  EXPECT_EQ(ask(ArmAction::self_test, 0).refusal, ArmRefusal::none) << "again while it runs";
  const std::uint32_t first = nonce_after_switch();
  const ArmReply again = ask(ArmAction::begin, 7);
  ASSERT_TRUE(again.nonce);
  EXPECT_NE(*again.nonce, first);
  EXPECT_EQ(ask(ArmAction::confirm, *again.nonce).refusal, ArmRefusal::none);
  EXPECT_EQ(place.record.phase, core::Phase::armed);
  EXPECT_EQ(ask(ArmAction::confirm, *again.nonce).refusal, ArmRefusal::not_safe);
  EXPECT_EQ(place.record.phase, core::Phase::armed);
  place.world->set_arm_switch(false);
  live(100);
  EXPECT_EQ(place.record.phase, core::Phase::safe);
}

TEST_F(ArmByManual, AnOlderNonceIsWrongAndUsesTheNewestUp) {
  (void)ask(ArmAction::self_test, 0);
  const std::uint32_t first = nonce_after_switch();
  const std::uint32_t newest = ask(ArmAction::begin, 0).nonce.value_or(0);
  EXPECT_EQ(ask(ArmAction::confirm, first).refusal, ArmRefusal::wrong_nonce);
  EXPECT_EQ(ask(ArmAction::confirm, newest).refusal, ArmRefusal::no_nonce);
  EXPECT_EQ(place.record.phase, core::Phase::safe);
}

}  // namespace
}  // namespace fantail::sil
