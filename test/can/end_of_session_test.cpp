// SPDX-License-Identifier: MIT
#include <algorithm>
#include <csignal>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

// However a bench session ends, the canards are centred.

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

using protocol::CommandReport;
using protocol::EncoderReport;

constexpr double encoder_centre_deg = 0.5;  ///< as far as the encoders of this rocket are off
constexpr double bus_step_deg = 0.011;

bool centred(Ear& ear) {
  return ear.until([&] {
    const auto& session = ear.link().newest<protocol::SessionReply>();
    return session && session->message.state == protocol::SessionState::closed &&
           farthest_deg(ear.newest<CommandReport>().angle) == 0.0F;
  });
}

TEST_F(AtARocket, HoldKeepsOneCanardAtItsAngleAndLeavesTheOthersAlone) {
  Ear ear{"vcan0"};
  Dump dump{"vcan0"};
  const Outcome outcome = fantail_bench({"hold", "2", "-5", "--can", "vcan0", "--for", "3", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "the canards are centred\n");
  std::istringstream lines{outcome.out};
  int number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    const json::Value said = json::parse(line);
    EXPECT_EQ(said["canard"], 2);
    EXPECT_EQ(said["asked_deg"], -5.0);
    EXPECT_NEAR(said["command_deg"].number(), -5.0, bus_step_deg) << line;
    EXPECT_NEAR(said["encoder_deg"].number(), -5.0, encoder_centre_deg) << line;
    EXPECT_EQ(said["limited"], false);
  }
  EXPECT_EQ(number, 3) << outcome.out;
  // On the bus: this canard went there, and no other one was ever told to move.
  float farthest = 0.0F;
  for (const CommandReport& report : reports<CommandReport>(dump.log())) {
    for (std::size_t i = 0; i < 4; ++i) {
      const float told_deg = report.angle[i].value_or(core::Angle{}).degrees();
      if (i == 1) {
        farthest = std::min(farthest, told_deg);
      } else {
        ASSERT_EQ(told_deg, 0.0F) << "canard " << i + 1;
      }
    }
  }
  EXPECT_NEAR(farthest, -5.0F, bus_step_deg);
  EXPECT_TRUE(centred(ear));
}

TEST_F(AtARocket, HoldBeyondTheLimitIsClampedAndSaysSo) {
  const Outcome outcome = fantail_bench({"hold", "4", "15", "--can", "vcan0", "--for", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED2(contains, outcome.out, "canard 4: asked +15.00 deg, command +9.00 deg (limited), encoder +");
}

TEST_F(AtARocket, HoldGoesOnUntilASignalEndsItWithTheCanardsCentred) {
  Ear ear{"vcan0"};
  for (int attempt = 0; attempt < 5; ++attempt) {
    Program bench{{"bench", "hold", "1", "6", "--can", "vcan0"}};
    EXPECT_TRUE(ear.until([&] { return bench.ended() || farthest_deg(ear.newest<EncoderReport>().angle) > 5.0F; }));
    EXPECT_TRUE(bench.says("canard 1: asked +6.00 deg, command +6.00 deg, encoder +") || bench.ended());
    bench.signal(SIGINT);
    const Outcome& outcome = bench.outcome();
    if (starved(outcome)) {
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "the canards are centred\n");
    EXPECT_TRUE(centred(ear));
    return;
  }
  ADD_FAILURE() << "this machine is too busy";
}

TEST_F(AtARocket, HoldIsRefusedWhileAnotherBenchHoldsACanard) {
  Ear ear{"vcan0"};
  for (int attempt = 0; attempt < 5; ++attempt) {
    Program first{{"bench", "hold", "3", "4", "--can", "vcan0"}};
    EXPECT_TRUE(first.says("canard 3: asked +4.00 deg") || first.ended());
    const Outcome second = fantail({"bench", "hold", "3", "-4", "--can", "vcan0", "--for", "1"});
    if (first.ended() && starved(first.outcome())) {
      continue;
    }
    EXPECT_EQ(second.exit_code, 74);
    EXPECT_PRED2(contains, second.err, "another bench has the session");
    EXPECT_TRUE(ear.until([&] { return farthest_deg(ear.newest<CommandReport>().angle) > 3.9F; })) << "still held";
    first.signal(SIGTERM);
    EXPECT_EQ(first.outcome().exit_code, 0) << first.outcome().err;
    EXPECT_TRUE(centred(ear));
    return;
  }
  ADD_FAILURE() << "this machine is too busy";
}

}  // namespace

}  // namespace fantail::test
