// SPDX-License-Identifier: MIT
#include <csignal>
#include <sstream>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;
using namespace std::chrono_literals;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream{text};
  for (std::string line; std::getline(stream, line);) {
    all.push_back(line);
  }
  return all;
}

TEST_F(AtARocket, WatchSaysALineASecondOrAnObjectAndEndsByCtrlC) {
  const auto begin = std::chrono::steady_clock::now();
  Program plain{{"bench", "watch", "--can", "vcan0"}};
  Program objects{{"bench", "watch", "--can", "vcan0", "--json"}};
  EXPECT_TRUE(eventually([&] { return lines(objects.said()).size() >= 4 && lines(plain.said()).size() >= 4; }));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 4s) << "less than a second for a line";
  for (Program* each : {&plain, &objects}) {
    each->signal(SIGINT);
    EXPECT_EQ(each->outcome().exit_code, 0);
    EXPECT_EQ(each->outcome().err, "");
  }
  for (const std::string& line : lines(plain.outcome().out)) {
    EXPECT_TRUE(line.starts_with("safe (power_on); canard 1 ")) << line;
    EXPECT_PRED2(contains, line, "vcan0 error active, load ");
  }
  double before_s = 0.0;
  for (const std::string& line : lines(objects.outcome().out)) {
    const Json object = json::parse(line);
    EXPECT_GT(object["uptime_s"].number(), before_s);
    before_s = object["uptime_s"].number();
  }
}

// As on a PC that was suspended: the frames waited in the socket, and nobody was silent.
TEST_F(AtARocket, AWatchThatWasHeldUpSaysNothingFalse) {
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  ASSERT_TRUE(eventually([&] { return lines(watch.said()).size() >= 2; }));
  watch.signal(SIGSTOP);
  std::this_thread::sleep_for(4s);
  const std::size_t before = lines(watch.said()).size();
  watch.signal(SIGCONT);
  ASSERT_TRUE(eventually([&] { return lines(watch.said()).size() >= before + 3; }));
  watch.signal(SIGINT);
  for (const std::string& line : lines(watch.outcome().out)) {
    const Json object = json::parse(line);
    EXPECT_FALSE(object["phase"].is_null()) << "silent: " << line;
    EXPECT_LE(object["bus_load_percent"].number(), 100.0) << line;
  }
}

TEST_F(AtARocket, WatchEndsWithItsReader) {
  const Outcome outcome =
      run("sh", {"-c", "{ \"$0\" bench watch --can vcan0; echo code $? >&2; } | head -n 1", fantail_path()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(lines(outcome.out).size(), 1U) << outcome.out;
  EXPECT_EQ(outcome.err, "code 0\n");
}

TEST_F(CanSystem, WatchOnAFullDiskIsAnOutputFault) {
  const Outcome outcome =
      fantail({"bench", "watch", "--can", "vcan0"}, {.prepare = redirect(STDOUT_FILENO, "/dev/full")});
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_PRED2(contains, outcome.err, "standard output");
}

TEST_F(CanSystem, ASilentBusIsSaidToBeSilent) {
  const Outcome watch = fantail({"bench", "watch", "--can", "vcan0", "--for", "1"});
  EXPECT_EQ(watch.exit_code, 0);
  EXPECT_PRED2(contains, watch.out, "the avionics is silent");
  const Outcome limits = fantail({"bench", "limits", "--can", "vcan0"});
  EXPECT_EQ(limits.exit_code, 74);
  EXPECT_PRED2(contains, limits.err, "the avionics is silent: is it powered");
}

TEST_F(CanSystem, ANodeEndsAfterItsTime) {
  const Folder folder;
  const Outcome outcome =
      fantail({"node", "bench_healthy", "--can", "vcan0", "--for", "2", "--flash", folder / "flash.bin"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED2(contains, outcome.out, "bench_healthy (Tasha III, bench) on vcan0");
  EXPECT_PRED2(contains, outcome.out, "ended after ");
}

TEST_F(AtARocket, ASecondOneWithTheSameFlashIsRefused) {
  const std::string flash = node->folder / "flash.bin";
  const Outcome second = fantail({"node", "bench_healthy", "--can", "vcan0", "--flash", flash});
  EXPECT_EQ(second.exit_code, 74);
  EXPECT_EQ(second.err, "fantail: " + flash + ": is the flash of another process that is running\n");
  EXPECT_EQ(second.out, "");
}

}  // namespace
}  // namespace fantail::test
