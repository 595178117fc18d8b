// SPDX-License-Identifier: MIT
#include <csignal>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

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
