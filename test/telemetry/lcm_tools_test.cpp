// SPDX-License-Identifier: MIT
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>

#include "json/value.hpp"
#include "linux/shell.hpp"
#include "telemetry/multicast.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;
using namespace std::chrono_literals;

const std::string url = "udpm://239.255.76.67:7667?ttl=0";
// What this scenario does; each stands in its summary too.
const std::vector<std::string> flight_events{
    "safe -> armed (armed_by_switch_and_command)", "armed -> launched (launch_detected)",
    "launched -> controlling (guide_clear)", "controlling -> finished (apogee)"};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::map<std::string, std::string> files(const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    all[entry.path().filename().string()] = content(entry.path());
  }
  return all;
}

/// In the same order, but some may be missing.
bool is_part_of(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  auto next = all.begin();
  return std::ranges::all_of(some, [&](const std::string& one) {
    next = std::find(next, all.end(), one);
    const bool found = next != all.end();
    next += found ? 1 : 0;
    return found;
  });
}

/// Everything in a log, as fast as it can be read.
std::vector<Json> in_log(const std::string& log) {
  const Outcome outcome = fantail({"watch", "--lcm", "file://" + log + "?speed=0", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return objects(outcome.out);
}

/// A flight in a log, once for all tests.
class LcmTools : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    flight = std::make_unique<Folder>();
    const Outcome outcome = fantail({"fly", "--out", *flight / "out", "--lcm", "file://" + log()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  static void TearDownTestSuite() { flight.reset(); }
  void SetUp() override { follow_the_advice(); }
  static std::string log() { return *flight / "flight.lcmlog"; }
  static inline std::unique_ptr<Folder> flight;
  Folder folder;
};

TEST_F(LcmTools, WithoutARouteTheMessageSaysWhichCommandMendsIt) {
  take_the_route_away();
  const std::string out = folder / "out";
  for (const auto& arguments :
       {std::vector<std::string>{"fly", "--out", out, "--lcm", url}, std::vector<std::string>{"watch", "--lcm", url}}) {
    const Outcome outcome = fantail(arguments);
    EXPECT_EQ(outcome.exit_code, 74);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "fantail: " + url +
                               ": multicast has no route on this computer. Connect it to a network; or keep the "
                               "messages on this computer: sudo ip link set lo up; sudo ip route add 224.0.0.0/4 dev "
                               "lo\n");
  }
  EXPECT_FALSE(std::filesystem::exists(out));
  must("ip link set lo up; ip route add 224.0.0.0/4 dev lo");
  EXPECT_EQ(fantail({"fly", "--out", out, "--lcm", url}).exit_code, 0);
}

TEST_F(LcmTools, AUrlThatIsNoneIsAUsageError) {
  const Outcome outcome = fantail({"fly", "--out", folder / "out", "--lcm", "udpm://10.0.0.1:7667"});
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_PRED2(contains, outcome.err, "\"10.0.0.1\" is not a multicast address; allowed: udpm://ADDRESS:PORT");
  EXPECT_EQ(fantail({"watch"}).exit_code, 64);
  EXPECT_EQ(fantail({"gateway", "--can", "vcan0"}).exit_code, 64);
}

TEST_F(LcmTools, AFlightIsTheSameToTheByteWithAndWithoutLcm) {
  EXPECT_EQ(fantail({"fly", "--out", folder / "plain"}).exit_code, 0);
  EXPECT_EQ(fantail({"fly", "--out", folder / "sent", "--lcm", url}).exit_code, 0);
  EXPECT_EQ(files(folder / "plain"), files(folder / "sent"));
  EXPECT_EQ(files(folder / "plain"), files(*flight / "out"));
}

TEST_F(LcmTools, TheSummaryForAScriptStaysAlone) {
  const Outcome plain = fantail({"fly", "--out", folder / "plain", "--json"});
  const Outcome sent = fantail({"fly", "--out", folder / "sent", "--json", "--lcm", url});
  EXPECT_EQ(sent.exit_code, 0);
  EXPECT_EQ(plain.out, sent.out);
}

TEST_F(LcmTools, TheLogHasEveryMessageOfTheFlight) {
  const auto seen = in_log(log());
  // 100 and 10 a second, from the first tick to the last one of flight.csv.
  const std::string csv = content(*flight / "out/flight.csv");
  const std::int64_t ticks = std::ranges::count(csv, '\n') - 1;
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "received"), (ticks + 9) / 10);
  EXPECT_EQ(total(seen, "FANTAIL_CANARDS", "received"), (ticks + 9) / 10);
  EXPECT_EQ(total(seen, "FANTAIL_HEALTH", "received"), (ticks + 99) / 100);
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "lost"), 0);
  EXPECT_EQ(events(seen), flight_events);
}

// The tool of LCM that most people record with, and the program that publishes as fast as receivers can be expected to
// take it.
TEST_F(LcmTools, LcmLoggerRecordsWhatFlyPublishes) {
  const std::string recorded = folder / "recorded.lcmlog";
  Program logger{"lcm-logger", {"--lcm-url=" + url, recorded}};
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(recorded); }));
  std::this_thread::sleep_for(500ms);  // it says nothing when it listens
  const Outcome fly = fantail({"fly", "--out", folder / "out", "--lcm", url});
  EXPECT_EQ(fly.exit_code, 0) << fly.err;
  EXPECT_PRED2(contains, fly.out, " messages to " + url + "\n");
  std::this_thread::sleep_for(500ms);  // it writes ten times a second
  logger.signal(SIGTERM);
  (void)logger.outcome();
  const auto wanted = in_log(log());
  const auto seen = in_log(recorded);
  for (const char* channel : {"FANTAIL_STATE", "FANTAIL_CANARDS", "FANTAIL_HEALTH"}) {
    const std::int64_t sent = total(wanted, channel, "received");
    // UDP may lose on a busy machine, in a guest with one processor above all; it must be told as lost then.
    EXPECT_GT(total(seen, channel, "received"), sent / 2) << channel;
    // What a busy machine loses at the very beginning or end, nobody can know of.
    EXPECT_LE(total(seen, channel, "received") + total(seen, channel, "lost"), sent) << channel;
    EXPECT_EQ(total(seen, channel, "duplicate") + total(seen, channel, "unreadable"), 0) << channel;
  }
  EXPECT_TRUE(is_part_of(events(seen), flight_events)) << testing::PrintToString(events(seen));
}

TEST_F(LcmTools, LcmLogplayerPlaysItAndWatchShowsTheFlightAgain) {
  Watcher watcher{url};
  const Outcome player = run("lcm-logplayer", {"--speed=5", "--lcm-url=" + url, log()});
  EXPECT_EQ(player.exit_code, 0) << player.err;
  const auto wanted = in_log(log());
  EXPECT_TRUE(eventually([&] { return !watcher.seen().empty() && watcher.seen().back()["state"]["stale"] == true; }));
  watcher.program().signal(SIGINT);
  EXPECT_EQ(watcher.program().outcome().exit_code, 0);
  EXPECT_EQ(watcher.program().outcome().err, "");
  const auto seen = watcher.seen();
  EXPECT_EQ(seen.front()["link"], "silent");
  EXPECT_EQ(events(seen), flight_events);
  EXPECT_EQ(seen.back()["channels"]["FANTAIL_STATE"]["total"], wanted.back()["channels"]["FANTAIL_STATE"]["total"]);
  // What was live, is now said to be old; it is still what was said last.
  const auto last_live = std::ranges::find_if(seen, [](const Json& object) { return object["link"] == "live"; });
  EXPECT_NE(last_live, seen.end());
  EXPECT_EQ(seen.back()["link"], "stale");
  for (const char* value : {"roll_angle_deg", "command_deg", "height_m", "phase", "time_s"}) {
    EXPECT_EQ(seen.back()["state"][value], wanted.back()["state"][value]) << value;
  }
}

// Twice, into the same watch: the numbers begin again from zero.
TEST_F(LcmTools, ALogThatIsPlayedTwiceIsFollowedTwice) {
  Watcher watcher{url};
  const std::vector<std::string> play{"--speed=20", "--lcm-url=" + url, log()};
  EXPECT_EQ(run("lcm-logplayer", play).exit_code, 0);
  EXPECT_EQ(run("lcm-logplayer", play).exit_code, 0);
  const auto wanted = in_log(log());
  EXPECT_TRUE(eventually([&] {
    const auto seen = watcher.seen();
    return seen.back()["restarts"] == 1 && seen.back()["state"]["time_s"] == wanted.back()["state"]["time_s"];
  }));
}

TEST_F(LcmTools, AFullDiskIsAnErrorOfTheTelemetryAndNotOfTheFlight) {
  const std::string out = folder / "out";
  const Outcome outcome = fantail({"fly", "--out", out, "--lcm", "file:///dev/full"});
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_PRED2(contains, outcome.err, "file:///dev/full: not all messages could be written: is the disk full?");
  EXPECT_EQ(files(out), files(*flight / "out"));
}

TEST_F(LcmTools, WatchEndsWithItsReaderAndAfterItsTime) {
  const Outcome outcome =
      run("sh", {"-c", "{ \"$0\" watch --lcm \"$1\"; echo code $? >&2; } | head -n 1", fantail_path(), url});
  EXPECT_EQ(outcome.out, "link: SILENT, 0 received, 0 lost, 0 late, 0 duplicate in 1 s\n");
  EXPECT_EQ(outcome.err, "code 0\n");
  EXPECT_EQ(fantail({"watch", "--lcm", url, "--for", "0.1"}).exit_code, 0);
  EXPECT_EQ(fantail({"watch", "--lcm", "file://" + (folder / "none")}).exit_code, 74);
}

}  // namespace
}  // namespace fantail::test
