// SPDX-License-Identifier: MIT
#include <filesystem>
#include <sstream>

#include "can/rig.hpp"
#include "link/words.hpp"

namespace fantail::test {
namespace {

using core::Phase;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::StatusReport;

constexpr std::uint32_t arm_request_frame = 0x30;
const std::string call_for_the_switch = "Close the arm switch at the rocket.";

// Only what a bench says about arming: the rocket's own frames would contradict the rocket's.
std::string arm_requests(const std::string& log) {
  std::istringstream lines{log};
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (frames(line).front().frame.id == arm_request_frame) {
      kept += line + "\n";
    }
  }
  return kept;
}

/// Plays recorded requests to a rocket while a hand closes the switch as soon as the self-test has passed, as it did in
/// the first place. The rest follows when the switch is closed: in a busy guest a rocket's time goes slower.
struct Replay {
  Replay(const std::string& log, const std::string& interface, Node& rocket)
      : node{rocket},
        ear{interface},
        self_test{log.substr(0, log.find('\n') + 1)},
        rest{log.substr(self_test.size())} {}

  void play(const std::string& log) {
    player.emplace("canplayer", std::vector<std::string>{"-I", folder.write("log", log), node.interface + "=vcan0"});
    EXPECT_EQ(player->outcome().exit_code, 0) << player->outcome().err;
  }
  void close_switch_when_the_self_test_has_passed() {
    EXPECT_TRUE(ear.until([this] { return ear.newest<ArmReply>().self_test == protocol::SelfTestState::passed; }));
    node.program.type("switch close");
    EXPECT_TRUE(ear.until([this] { return ear.newest<StatusReport>().arm_switch_closed; }));
  }
  void expect_that_it_does_not_arm() {
    bool armed = false;
    EXPECT_TRUE(ear.until([&] {
      armed = armed || ear.newest<StatusReport>().phase != Phase::safe;
      return ear.newest<ArmReply>().refusal == ArmRefusal::wrong_nonce || armed;
    })) << "the confirmation was not looked at, but refused before: "
        << link::words(ear.newest<ArmReply>().refusal);
    EXPECT_FALSE(armed);
  }

  Folder folder;
  Node& node;
  Ear ear;
  std::string self_test;
  std::string rest;
  std::optional<Program> player;
};

TEST_F(CanSystem, ArmingTakesBothActionsAndItsReplayArmsNothing) {
  const Folder folder;
  const std::string flash = folder / "flash.bin";
  std::string recorded;
  {
    Node node{"vcan0", "bench_healthy", flash};
    Node other{"vcan1"};
    node.await_rest();
    other.await_rest();
    Ear ear{"vcan0"};
    Ear other_ear{"vcan1"};
    Dump dump{"vcan0"};
    Program arm{{"bench", "arm", "--can", "vcan0", "--yes"}};
    Program asking{{"bench", "arm", "--can", "vcan1"}};

    ASSERT_TRUE(arm.says(call_for_the_switch)) << arm.said();
    EXPECT_EQ(ear.newest<StatusReport>().phase, Phase::safe);
    node.program.type("switch close");
    EXPECT_EQ(arm.outcome().exit_code, 0) << arm.outcome().err;
    EXPECT_PRED2(contains, arm.outcome().out, "ARMED. Opening the arm switch makes the rocket safe again.\n");
    EXPECT_TRUE(ear.reaches(Phase::armed));
    recorded = arm_requests(dump.log());
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
  ASSERT_EQ(frames(recorded).size(), 3U) << "self-test, begin, confirm\n" << recorded;
  // After a reset, and on a rocket of which nothing is known: with flash as new as the first one's was.
  Node restarted{"vcan0", "bench_healthy", flash};
  Node fresh{"vcan1"};
  restarted.await_rest();
  fresh.await_rest();
  Replay to_restarted{recorded, "vcan0", restarted};
  Replay to_fresh{recorded, "vcan1", fresh};
  to_restarted.play(to_restarted.self_test);
  to_fresh.play(to_fresh.self_test);
  to_restarted.close_switch_when_the_self_test_has_passed();
  to_fresh.close_switch_when_the_self_test_has_passed();
  to_restarted.play(to_restarted.rest);
  to_fresh.play(to_fresh.rest);
  to_restarted.expect_that_it_does_not_arm();
  to_fresh.expect_that_it_does_not_arm();
}

}  // namespace
}  // namespace fantail::test
