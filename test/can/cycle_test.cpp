// SPDX-License-Identifier: MIT
#include <csignal>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

TEST_F(AtARocket, AnEnduranceRunWritesItsFiguresAndTellsEveryTenSeconds) {
  const Folder folder;
  const Outcome outcome =
      fantail_bench({"cycle", "--can", "vcan0", "--for", "12", "--vehicle", "tasha3_bench", "--out", folder / "run"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  EXPECT_PRED2(contains, outcome.out, "\nPASS\n  All four canards stayed within their tolerances in 3 laps");
  EXPECT_PRED2(contains, outcome.out, "The avionics does not report a battery voltage");
  EXPECT_PRED2(contains, outcome.err, "fantail: 10 s of 15: largest tracking error ");
  const json::Value run = json::parse(content(folder / "run/cycle.json"));
  EXPECT_EQ(run["judgement"], "pass");
  EXPECT_EQ(run["laps"], 3);
  EXPECT_EQ(run["canards"][2]["lag_s"]["tenths"].size(), 3U);
  EXPECT_PRED2(contains, content(folder / "run/cycle.csv"), "lap,time_s,measured,lag_1_s,");
}

TEST_F(AtARocket, AnEnduranceRunThatIsInterruptedKeepsWhatItHasMeasured) {
  const Folder folder;
  Ear ear{"vcan0"};
  for (int attempt = 0; attempt < 5; ++attempt) {
    Program bench{{"bench", "cycle", "--can", "vcan0", "--for", "600", "--json", "--out", folder / "run"}};
    EXPECT_TRUE(ear.until(
        [&] { return bench.ended() || ear.newest<protocol::SessionReply>().state == protocol::SessionState::open; }));
    // Into the second lap.
    const auto begin = ear.newest<protocol::HeartbeatReport>().uptime_ms;
    EXPECT_TRUE(
        ear.until([&] { return bench.ended() || ear.newest<protocol::HeartbeatReport>().uptime_ms > begin + 9'000; }));
    bench.signal(SIGINT);
    const Outcome& outcome = bench.outcome();
    if (starved(outcome)) {
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_PRED2(
        contains, outcome.err,
        "fantail: interrupted; the canards are centred; what was measured before is in " + (folder / "run") + "\n");
    const json::Value run = json::parse(outcome.out);
    EXPECT_EQ(outcome.out, content(folder / "run/cycle.json"));
    EXPECT_EQ(run["ended_because"], "interrupted");
    EXPECT_EQ(run["laps"], 1);
    EXPECT_EQ(run["planned_laps"], 120);
    EXPECT_TRUE(ear.until([&] { return farthest_deg(ear.newest<protocol::CommandReport>().angle) == 0.0F; }));
    return;
  }
  ADD_FAILURE() << "this machine is too busy";
}

}  // namespace
}  // namespace fantail::test
