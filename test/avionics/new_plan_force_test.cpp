// SPDX-License-Identifier: MIT
// When a plan that came by the bus comes into force.
#include <gtest/gtest.h>

#include "avionics/board_rig.hpp"
#include "avionics/plan_on_bus.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using protocol::PlanReply;
using protocol::TransferFault;
using protocol::TransferState;

core::FlightPlan plan_with_trim() {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = 4_deg;
  return plan;
}

std::uint32_t in_force(BoardRig& rig) {
  rig.run(200 * millisecond);  // the heartbeat comes ten times a second
  return rig.pc.heard<protocol::HeartbeatReport>()->plan_crc;
}

TEST(NewPlan, IsRefusedToAnArmedRocketAndChangesNothing) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  send_plan(rig, plan_with_trim());
  EXPECT_EQ(rig.pc.heard<PlanReply>()->fault, TransferFault::not_safe);
  EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan()));
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  rig.power_cycle();
  EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan()));
}

// What is past its point of no return is written to its end; it waits until it may move the canards.
TEST(NewPlan, OneThatIsWrittenWhileTheRocketIsCarriedIsNotInForceBeforeItRestsAgain) {
  int waited = 0;
  for (const int ticks : {0, 1, 2, 4, 8}) {
    BoardRig rig;
    rig.run(3 * second);
    send_plan(rig, plan_with_trim());
    rig.run(ticks * millisecond);
    const bool begun_before = rig.pc.heard<PlanReply>()->state == TransferState::stored;
    rig.hardware.imu.rate = {500, 0, 0};
    rig.run(300 * millisecond);
    const bool stored_meanwhile = rig.pc.heard<PlanReply>()->state == TransferState::writing;
    if (!begun_before) {
      EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan())) << ticks;
      EXPECT_TRUE(rig.all_pulses_are(0.0)) << ticks;
    }
    rig.hardware.imu.rate = {};
    rig.run(4 * second);
    if (stored_meanwhile) {
      EXPECT_EQ(in_force(rig), protocol::plan_crc(plan_with_trim())) << ticks;
      EXPECT_NEAR(rig.commanded_deg(1), 4.0, 0.01);
      waited += 1;
    }
  }
  EXPECT_GT(waited, 0);
}

}  // namespace
}  // namespace fantail::avionics
