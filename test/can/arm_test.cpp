// SPDX-License-Identifier: MIT
#include "avionics/can_frame.hpp"
#include "can/rig.hpp"

namespace fantail::test {
namespace {

using core::Phase;
using protocol::StatusReport;

const std::string call_for_the_switch = "Close the arm switch at the rocket.";

// That recorded frames arm nothing, after a reset and on another board, is tested in test/avionics.
TEST_F(CanSystem, ArmingTakesTheSwitchAndTheWordAndTheSwitchEndsIt) {
  Node node{"vcan0"};
  Node other{"vcan1"};
  node.await_rest();
  other.await_rest();
  Ear ear{"vcan0"};
  Ear other_ear{"vcan1"};
  Program arm{{"bench", "arm", "--can", "vcan0", "--yes"}};
  Program asking{{"bench", "arm", "--can", "vcan1"}};

  ASSERT_TRUE(arm.says(call_for_the_switch)) << arm.said();
  EXPECT_EQ(ear.newest<StatusReport>().phase, Phase::safe);
  node.program.type("switch close");
  EXPECT_EQ(arm.outcome().exit_code, 0) << arm.outcome().err;
  EXPECT_PRED2(contains, arm.outcome().out, "ARMED. Opening the arm switch makes the rocket safe again.\n");
  EXPECT_TRUE(ear.reaches(Phase::armed));
  node.program.type("switch open");
  EXPECT_TRUE(ear.reaches(Phase::safe));

  ASSERT_TRUE(asking.says(call_for_the_switch)) << asking.said();
  other.program.type("switch close");
  ASSERT_TRUE(asking.says("  closed\n")) << asking.said();
  asking.type("arm");
  EXPECT_EQ(asking.outcome().exit_code, 1);
  EXPECT_EQ(asking.outcome().err,
            "Type ARM to arm, anything else to leave the rocket safe: fantail: not confirmed; the rocket is safe\n");
  EXPECT_TRUE(other_ear.at_rest());
  EXPECT_EQ(other_ear.newest<StatusReport>().phase, Phase::safe);
}

// It says that a self-test runs and names no canard, as another rocket does that rests for its own.
TEST_F(CanSystem, AStrangersArmRepliesPutNoCanardOnTheTerminalThatIsNone) {
  Node node{"vcan0", "bench_healthy", "", {"imu.rate_bias_deg_s=0.3"}};
  node.await_rest();
  Program arm{{"bench", "arm", "--can", "vcan0", "--yes"}};
  hal::on_linux::CanBus stranger{"vcan0"};
  const auto running = encode(protocol::ArmReply{.self_test = protocol::SelfTestState::running});
  for (int canard = 1; canard <= 4; ++canard) {
    ASSERT_TRUE(arm.says("  canard " + std::to_string(canard) + "\n")) << arm.said();
    (void)stranger.send(avionics::can_frame(running));
  }
  ASSERT_TRUE(arm.says(call_for_the_switch)) << arm.said();
  node.program.type("switch close");
  EXPECT_EQ(arm.outcome().exit_code, 0) << arm.outcome().err;
  EXPECT_EQ(
      arm.outcome().out,
      "Self-test: keep the rocket still for three seconds; then each canard moves. Keep hands off.\n  canard 1\n  "
      "canard 2\n  canard 3\n  canard 4\n  passed; at rest the gyro reads 0.30 deg/s about the long axis, which is "
      "taken "
      "off\nClose the arm switch at the rocket.\n  closed\nARMED. Opening "
      "the arm switch makes the rocket safe again.\n");
}

}  // namespace
}  // namespace fantail::test
