// SPDX-License-Identifier: MIT
// However a bench session ends, the canards are centred.
#include <algorithm>
#include <csignal>

#include "can/rig.hpp"

namespace fantail::test {
namespace {

using protocol::CommandReport;
using protocol::EncoderReport;
using protocol::SessionReason;
using protocol::SessionReply;

constexpr std::uint32_t session_frame = 0x20;

/// A rocket and a bench on one bus.
struct Rehearsal {
  explicit Rehearsal(const std::string& bus) : interface{bus}, node{bus} {}

  /// Until canard 1 is well away from its centre.
  void go_into_the_middle_of_limits() {
    node.await_rest();
    for (int attempt = 0; attempt < 5; ++attempt) {
      bench.emplace(std::vector<std::string>{"bench", "limits", "--can", interface, "--out", folder / "sheet"});
      if (ear.until([this] { return farthest_deg(ear.newest<CommandReport>().angle) > 3.0F || bench->ended(); }) &&
          !bench->ended()) {
        return;
      }
      bench->signal(SIGINT);
      if (!starved(bench->outcome())) {
        break;
      }
    }
    throw std::runtime_error{"no canard moves: " + bench->outcome().err};
  }

  void expect_centred(SessionReason reason) {
    // The encoders' own centres are up to half a degree away.
    EXPECT_TRUE(ear.until([&] {
      const auto& session = ear.link().newest<SessionReply>();
      return session && session->message.state == protocol::SessionState::closed &&
             farthest_deg(ear.newest<CommandReport>().angle) == 0.0F &&
             farthest_deg(ear.newest<EncoderReport>().angle) < 1.0F;
    }));
    EXPECT_EQ(ear.newest<SessionReply>().reason, reason);
    EXPECT_TRUE(folder.listing().empty()) << "a sheet of half an exercise";
  }

  std::string interface;
  Folder folder;
  Node node;
  Ear ear{interface};
  std::optional<Program> bench;
};

TEST_F(CanSystem, ASignalInTheMiddleOfLimitsEndsItWithTheCanardsCentred) {
  Rehearsal one{"vcan0"};
  Rehearsal other{"vcan1"};
  for (const auto& [rehearsal, signal] : {std::pair{&one, SIGINT}, {&other, SIGTERM}}) {
    std::string until_its_end;
    for (int attempt = 0; attempt == 0 || (attempt < 5 && starved(rehearsal->bench->outcome())); ++attempt) {
      rehearsal->go_into_the_middle_of_limits();
      Dump dump{rehearsal->interface};
      rehearsal->bench->signal(signal);
      (void)rehearsal->bench->outcome();
      until_its_end = dump.log();
    }
    const Outcome& outcome = rehearsal->bench->outcome();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.err, "fantail: interrupted; the canards are centred\n");
    EXPECT_EQ(outcome.out, "");
    // When it said so it was so.
    EXPECT_EQ(farthest_deg(reports<CommandReport>(until_its_end).back().angle), 0.0F);
    rehearsal->expect_centred(SessionReason::closed_by_bench);
  }
}

// In ticks, because the bus carries one command report a tick while the session is open, and the guest's clock
// stutters.
void expect_a_hundred_ticks_after_the_last_heartbeat(const std::string& log) {
  const std::vector<LoggedFrame> all = frames(log);
  const auto last =
      std::find_if(all.rbegin(), all.rend(), [](const auto& one) { return one.frame.id == session_frame; });
  ASSERT_NE(last, all.rend());
  int ticks = 0;
  for (auto each = last.base(); each != all.end(); ++each) {
    const auto command = report<CommandReport>(each->frame);
    ticks += command ? 1 : 0;
    if (command && farthest_deg(command->angle) == 0.0F) {
      break;
    }
  }
  EXPECT_GE(ticks, 100);
  EXPECT_LE(ticks, 103);
}

TEST_F(CanSystem, ABenchThatIsKilledLosesTheCanardsAndARocketThatDiesIsNoticed) {
  Rehearsal dying_bench{"vcan0"};
  Rehearsal dying_rocket{"vcan1"};

  Dump dump{"vcan0"};
  dying_bench.go_into_the_middle_of_limits();
  dying_bench.bench->signal(SIGKILL);
  EXPECT_EQ(dying_bench.bench->outcome().signal, SIGKILL);
  dying_bench.expect_centred(SessionReason::heartbeat_lost);
  expect_a_hundred_ticks_after_the_last_heartbeat(dump.log());

  dying_rocket.go_into_the_middle_of_limits();
  dying_rocket.node.program.signal(SIGKILL);
  const Outcome& outcome = dying_rocket.bench->outcome();
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_EQ(outcome.err,
            "fantail: the avionics has stopped reporting; it centres the canards by itself if it still runs\n");
  EXPECT_TRUE(dying_rocket.folder.listing().empty());
}

TEST_F(CanSystem, AnInterfaceThatGoesDownInTheMiddleOfLimitsEndsItAndTheRocketCentresItself) {
  Rehearsal rehearsal{"vcan0"};
  rehearsal.go_into_the_middle_of_limits();
  must("ip link set vcan0 down");
  const Outcome& outcome = rehearsal.bench->outcome();
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_PRED2(contains, outcome.err,
               "fantail: the CAN interface is down; the avionics centres the canards by itself 0.1 s after the last "
               "heartbeat\n");
  must("ip link set vcan0 up");
  rehearsal.expect_centred(SessionReason::heartbeat_lost);
}

}  // namespace
}  // namespace fantail::test
