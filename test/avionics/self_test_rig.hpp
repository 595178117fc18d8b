// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {

// Until it has ended one way or the other.
inline protocol::ArmReply outcome(BoardRig& rig, Microseconds patience = 20 * second) {
  using namespace protocol;
  rig.pc.say(ArmAction::self_test);
  rig.run(2 * millisecond);
  for (Microseconds waited{}; waited < patience; waited += millisecond) {
    if (rig.pc.heard<ArmReply>() && rig.pc.heard<ArmReply>()->self_test != SelfTestState::running) {
      break;
    }
    rig.tick();
  }
  return rig.pc.heard<ArmReply>().value_or(ArmReply{});
}

inline void expect_failure(BoardRig& rig, protocol::SelfTestFailure failure, std::optional<std::size_t> canard = {}) {
  const protocol::ArmReply reply = outcome(rig);
  EXPECT_EQ(reply.self_test, protocol::SelfTestState::failed);
  EXPECT_EQ(reply.failure, failure);
  EXPECT_EQ(reply.canard, canard);
  EXPECT_TRUE(rig.run(second)->phase == core::Phase::safe && rig.all_pulses_are(0.0)) << "the canards are let go";
}

}  // namespace fantail::avionics
