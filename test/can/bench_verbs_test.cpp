// SPDX-License-Identifier: MIT
#include <cmath>
#include <csignal>
#include <sstream>

#include "avionics/can_frame.hpp"
#include "can/rig.hpp"
#include "json/value.hpp"

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
  EXPECT_EQ(arm.outcome().out,
            "Self-test: keep the rocket still for three seconds; then each canard moves. Keep hands off.\n  canard 1\n "
            " canard 2\n  canard 3\n  canard 4\n  passed; at rest the gyro reads 0.30 deg/s about the long axis, which "
            "is subtracted\n  abort input: none fitted\nClose the arm switch at the rocket.\n  closed\nARMED. Opening "
            "the arm switch makes the rocket safe again.\n");
}

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
        "fantail: interrupted; the canards are centred; the earlier measurements are in " + (folder / "run") + "\n");
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

TEST_F(CanSystem, ZeroFindsAHornThatIsOffAndWritesAPlanThatCorrectsIt) {
  Node node{"vcan0", "bench_canard3_wrong_trim"};
  node.await_rest();
  const Folder folder;
  const std::string plan = folder / "corrected.toml";
  const Outcome measured =
      fantail_bench({"zero", "--can", "vcan0", "--plan", "tasha3_launch2", "--json", "--write", plan});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const json::Value zero = json::parse(measured.out);
  EXPECT_EQ(zero["trusted"], "encoder");
  EXPECT_NEAR(zero["canards"][2]["centre_deg"]["value"].number(), 2.5, 0.6);
  // The file is the plan in force but for the two lines.
  std::istringstream before{fantail({"plan", "show", "tasha3_launch2"}).out};
  std::istringstream after{content(plan)};
  std::string changed;
  std::string old_line;
  std::string new_line;
  while (std::getline(before, old_line) && std::getline(after, new_line)) {
    changed += old_line == new_line ? "" : new_line.substr(0, new_line.find(' ')) + ' ';
  }
  EXPECT_EQ(changed, "pulse_centre_us pulse_per_degree_us ");

  const Outcome again = fantail({"bench", "zero", "--can", "vcan0", "--write", plan});
  EXPECT_EQ(again.exit_code, 74);
  EXPECT_PRED2(contains, again.err, "exists, and no plan is overwritten; choose another name for the new plan");
  ASSERT_EQ(fantail_bench({"plan", plan, "--can", "vcan0"}).exit_code, 0);
  const Outcome step = fantail_bench({"hold", "3", "0", "--can", "vcan0", "--wait", "30", "--for", "2", "--json"});
  ASSERT_EQ(step.exit_code, 0) << step.err;
  const std::string last = step.out.substr(step.out.find('\n') + 1);
  EXPECT_NEAR(json::parse(last)["encoder_deg"].number(), 0.0, 0.2) << "it was 2.5";
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

TEST_F(CanSystem, ZeroRefusesAReversedCanardAndWritesNothing) {
  Node node{"vcan0", "bench_canard3_reversed"};
  node.await_rest();
  const Folder folder;
  const Outcome refused = fantail_bench({"zero", "--can", "vcan0", "--write", folder / "plan.toml"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_PRED2(contains, refused.err, "Canard 3 is not measured: its encoder moves against the command.");
  EXPECT_PRED2(contains, refused.err, "Nothing was written.");
  EXPECT_EQ(refused.out, "");
  EXPECT_TRUE(folder.listing().empty());
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

using Json = json::Value;

Json last_object(const std::string& lines) {
  const std::size_t end = lines.rfind('\n');
  const std::size_t begin = end == std::string::npos || end == 0 ? 0 : lines.rfind('\n', end - 1) + 1;
  return end == std::string::npos ? Json{} : json::parse(lines.substr(begin, end - begin));
}

TEST_F(CanSystem, AnInterfaceThatGoesDownAndComesBackIsNoticedAndNothingHasToBeStartedAgain) {
  Node node{"vcan0"};
  node.await_rest();
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const auto shows = [&](const std::function<bool(const Json&)>& question) {
    return eventually([&] {
      const Json object = last_object(watch.said());
      return object.is_object() && question(object);
    });
  };
  EXPECT_TRUE(shows([](const Json& now) { return now["bus_state"] == "error active" && now["phase"] == "safe"; }));
  must("ip link set vcan0 down");
  EXPECT_TRUE(shows([](const Json& now) { return now["bus_state"] == "down" && now["phase"].is_null(); }));
  const auto frames_before = last_object(watch.said())["frames"].number();
  must("ip link set vcan0 up");
  EXPECT_TRUE(shows([&](const Json& now) {
    return now["bus_state"] == "error active" && now["phase"] == "safe" && now["frames"].number() > frames_before + 100;
  }));
  // It was down, and not switched off: the rocket's time has gone on.
  EXPECT_GT(last_object(watch.said())["uptime_s"].number(), 4.0);
  watch.signal(SIGINT);
  EXPECT_EQ(watch.outcome().exit_code, 0) << watch.outcome().err;
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0) << node.program.outcome().err;
}

TEST_F(CanSystem, ANodeThatAPcHeldUpSaysSoOnTheBusAndCanStillBeArmed) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  node.program.signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds{1});
  node.program.signal(SIGCONT);
  EXPECT_TRUE(ear.until([&] { return ear.newest<protocol::BoardReport>().overruns == 255; }));
  EXPECT_EQ(ear.newest<protocol::BoardReport>().faults, 0U);
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0) << node.program.outcome().err;
}

}  // namespace

}  // namespace fantail::test
