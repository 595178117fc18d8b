// SPDX-License-Identifier: MIT
#include "avionics/avionics.hpp"

#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;

core::FlightPlan tunnel_plan() {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  return plan;
}

TEST(Avionics, WritesTheServosOncePerTick) {
  BoardRig rig;
  rig.tick();
  rig.tick();
  EXPECT_EQ(rig.servo.writes, 2);
}

TEST(Avionics, HoldsTheCanardsAtTrimInSafe) {
  BoardRig rig;
  rig.run(100 * millisecond);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(Avionics, LeavesACanardOffWhoseEncoderHasNotSpoken) {
  BoardRig rig;
  rig.unplugged[2] = true;
  rig.tick();
  EXPECT_TRUE(rig.servo.written[0].has_value());
  EXPECT_FALSE(rig.servo.written[2].has_value());
}

TEST(Avionics, FeedsTheWatchdogOncePerCompletedTick) {
  BoardRig rig;
  rig.run(10 * millisecond);
  EXPECT_EQ(rig.watchdog.fed, 10);
}

TEST(Avionics, TellsThePersonAtTheConsoleEveryPhaseAndItsReason) {
  BoardRig rig;
  rig.make_ready();
  rig.console.text.clear();
  rig.arm();
  EXPECT_EQ(rig.console.text, "phase: armed, armed_by_switch_and_command\n");
}

TEST(Avionics, APositiveRollRateTurnsTheCanardsAgainstIt) {
  BoardRig rig{tunnel_plan()};
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.pc.say(protocol::ArmAction::start, rig.armed_with);
  ASSERT_EQ(rig.tick().phase, Phase::controlling);
  rig.hardware.imu.rate = {1000, 0, 0};  // 1 rad/s times 0.05 s
  rig.tick();
  const core::TickRecord& record = rig.tick();
  EXPECT_NEAR(record.command.radians(), -0.05F, 0.005F);
  EXPECT_LT(*rig.servo.written[0], hal::Pulse{1'500'000});
}

TEST(Avionics, BothAccelerometersEncodersAndTheClockReachTheRecord) {
  BoardRig rig;
  rig.shaft_deg[1] = 11.25;
  rig.jammed[1] = true;
  const core::TickRecord& record = rig.tick();
  EXPECT_EQ(record.time, Microseconds{1000});
  EXPECT_NEAR(record.encoders[1]->degrees(), 11.25F, 1e-4F);
  EXPECT_NEAR(record.canard_angle->degrees(), 11.25F / 4.0F, 1e-4F);
}

TEST(Avionics, ABusThatIsGoneChangesNothingElse) {
  BoardRig rig;
  rig.wire.set_state(hal::CanState::down);
  EXPECT_EQ(rig.run(5 * second)->phase, Phase::safe);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.watchdog.fed, 5000);
  rig.wire.set_state(hal::CanState::error_active);
  rig.run(200 * millisecond);
  EXPECT_GT(rig.pc.heard<protocol::HealthReport>()->unsent, 0);
}

}  // namespace
}  // namespace fantail::avionics
