// SPDX-License-Identifier: MIT
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include <arpa/inet.h>
#include <fmt/core.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

// A block ends with its CRC-32C, the low byte first.
std::string checksum_of(const std::string& block) {
  std::uint32_t checksum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    checksum |= std::uint32_t{static_cast<unsigned char>(block[block.size() - 4 + i])} << (8 * i);
  }
  return fmt::format("{:08x}", checksum);
}

// That a plan stays in force over a power-up, and an old one when the new one is broken, is tested in test/sil.
TEST_F(CanSystem, APlanIsStoredAndABrokenOneIsRefused) {
  const Folder folder;
  ASSERT_EQ(fantail({"plan", "compile", "tunnel_steps", "--out", folder / "tunnel.ftpl"}).exit_code, 0);
  const std::string block = content(folder / "tunnel.ftpl");
  const std::string wanted = checksum_of(block);
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  const auto in_force = [&] { return fmt::format("{:08x}", ear.newest<protocol::HeartbeatReport>().plan_crc); };

  std::string broken = block;
  broken[broken.size() / 2] ^= 4;
  const std::string file = folder.write("broken.ftpl", broken);
  const Outcome refused = fantail({"bench", "plan", file, "--can", "vcan0", "--json"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err,
            "fantail: the avionics refuses " + file + ": its checksum is wrong; its old plan stays in force\n");
  EXPECT_EQ(json::parse(refused.out)["refused_because"], "its checksum is wrong");

  const Outcome stored = fantail({"bench", "plan", "tunnel_steps", "--can", "vcan0"});
  EXPECT_EQ(stored.exit_code, 0) << stored.err;
  EXPECT_PRED2(contains, stored.out, "tunnel_steps: " + std::to_string(block.size()) + " bytes sent");
  EXPECT_TRUE(ear.until([&] { return in_force() == wanted; })) << in_force();
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

TEST_F(CanSystem, ThePlanInForceIsShownAsAFileThatGivesItAgain) {
  const std::string plan = std::string{FANTAIL_TEST_SOURCE} + "/test/can/every_field.toml";
  const Folder folder;
  Node node{"vcan0"};
  node.await_rest();
  const Outcome before = fantail_bench({"plan", "show", "--can", "vcan0"});
  ASSERT_EQ(before.exit_code, 0) << before.err;
  EXPECT_PRED2(contains, before.err, "the plan in force is the built-in one; none is stored; block_crc ");
  EXPECT_EQ(before.out, fantail({"plan", "show", "tasha3_launch2"}).out);

  ASSERT_EQ(fantail_bench({"plan", plan, "--can", "vcan0"}).exit_code, 0);
  const Outcome after = fantail_bench({"plan", "show", "--can", "vcan0"});
  ASSERT_EQ(after.exit_code, 0) << after.err;
  EXPECT_EQ(after.out, fantail({"plan", "show", plan}).out);
  ASSERT_EQ(fantail({"plan", "compile", plan, "--out", folder / "sent.ftpl"}).exit_code, 0);
  const std::string shown = folder.write("shown.toml", after.out);
  ASSERT_EQ(fantail({"plan", "compile", shown, "--out", folder / "shown.ftpl"}).exit_code, 0);
  EXPECT_EQ(content(folder / "shown.ftpl"), content(folder / "sent.ftpl"));
  const std::string crc = checksum_of(content(folder / "sent.ftpl"));
  EXPECT_PRED2(contains, after.err, "vcan0: the plan in force is the one in the flash; block_crc " + crc + "\n");

  const Outcome in_json = fantail_bench({"plan", "show", "--can", "vcan0", "--json"});
  const json::Value read = json::parse(in_json.out);
  EXPECT_EQ(read["origin"], "stored");
  EXPECT_EQ(read["block_crc"], crc);
  const json::Value file = json::parse(fantail({"plan", "show", plan, "--json"}).out);
  for (const json::Member& section : read["plan"].members()) {
    EXPECT_EQ(section.value.pretty(), file[section.key].pretty()) << section.key;
  }
  EXPECT_EQ(read["plan"].size() + 3, file.size()) << "answer, sentence and made";
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

/// A client that was written from the manual and the database, with python-can and cantools.
Outcome load_by_the_manual(const std::string& plan) {
  const std::string source = FANTAIL_TEST_SOURCE;
  return run(source + "/test/with_python.sh", {source + "/test/can/plan_client.py", source + "/docs",
                                               source + "/firmware/protocol/canard_bus.dbc", plan, "--can", "vcan0"});
}

TEST_F(WithCantools, AClientWrittenFromTheManualAloneLoadsAPlan) {
  const std::string plan = std::string{FANTAIL_TEST_SOURCE} + "/test/can/every_field.toml";
  const Folder folder;
  ASSERT_EQ(fantail({"plan", "compile", plan, "--out", folder / "plan.ftpl"}).exit_code, 0);
  const std::string wanted = checksum_of(content(folder / "plan.ftpl"));
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};

  const std::string too_wide = folder.write("too_wide.toml", "[controller]\ncanard_limit_deg = 25\n");
  const Outcome refused = load_by_the_manual(too_wide);
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_EQ(refused.out, "refused: bad_block, refused, controller.canard_limit_deg\n");

  const Outcome stored = load_by_the_manual(plan);
  EXPECT_EQ(stored.exit_code, 0) << stored.err;
  EXPECT_EQ(stored.out, "in force: " + wanted + "\nread back: the same 552 bytes\n");
  EXPECT_TRUE(ear.until([&] {
    return fmt::format("{:08x}", ear.newest<protocol::HeartbeatReport>().plan_crc) == wanted &&
           ear.newest<protocol::BoardReport>().plan == protocol::PlanSource::stored;
  }));
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

using Json = json::Value;

// A healthy rocket and one with canard 3 reversed, on two buses at the same time. All four canards through their whole
// course take half a minute: test/sil does that without a bus, and test/system as the README has it, with one.
TEST_F(CanSystem, AnExercisePassesTheHealthyRocketAndNamesTheReversedCanardOfTheOther) {
  Node healthy{"vcan0"};
  Node reversed{"vcan1", "bench_canard3_reversed"};
  healthy.await_rest();
  reversed.await_rest();
  const Folder folder;
  auto passing = std::async(std::launch::async, [&] {
    return fantail_bench({"step", "--can", "vcan0", "--canard", "3", "--vehicle", "tasha3_bench", "--plan",
                          "tasha3_launch2", "--json", "--out", folder / "healthy"});
  });
  const Outcome failed = fantail_bench(
      {"step", "--can", "vcan1", "--canard", "3", "--vehicle", "tasha3_bench", "--out", folder / "reversed/sheet"});
  const Outcome passed = passing.get();
  EXPECT_EQ(passed.exit_code, 0) << passed.err;
  EXPECT_FALSE(contains(passed.err, "fantail: ")) << passed.err;
  EXPECT_EQ(passed.out, content(folder / "healthy/sheet.json"));
  const Json sheet = json::parse(passed.out);
  EXPECT_EQ(sheet["passed"], true) << passed.out;
  EXPECT_EQ(sheet["exercise"], "step");
  EXPECT_EQ(sheet["plan"], "tasha3_launch2");
  EXPECT_EQ(sheet["canards"].size(), 1U);
  EXPECT_PRED2(contains, content(folder / "healthy/sheet.html"), "<html");

  EXPECT_EQ(failed.exit_code, 1) << failed.err;
  EXPECT_PRED2(contains, failed.out, "\nFAIL\n");
  EXPECT_PRED2(contains, failed.out, "Canard 3 is reversed");
  const Json bad_sheet = json::parse(content(folder / "reversed/sheet/sheet.json"));
  EXPECT_EQ(bad_sheet["passed"], false);
  EXPECT_EQ(bad_sheet["canards"][0]["cause"], "reversed") << bad_sheet["canards"][0];
  EXPECT_PRED2(contains, content(folder / "reversed/sheet/sheet.html"), "Canard 3 is reversed");
}

// What a browser is sent until the exercise has ended or the test has: it asks again and again.
std::string seen_by_a_browser(std::uint16_t port, const std::atomic<bool>& stop) {
  std::string seen;
  while (!stop && !contains(seen, R"("ended":true)")) {
    const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address{
        .sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(INADDR_LOOPBACK)}, .sin_zero = {}};
    const std::string question = fmt::format("GET /events HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", port);
    if (::connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        ::send(connection, question.data(), question.size(), MSG_NOSIGNAL) > 0) {
      std::array<char, 4096> part{};
      for (ssize_t n = 0; (n = ::recv(connection, part.data(), part.size(), 0)) > 0;) {
        seen.append(part.data(), static_cast<std::size_t>(n));
      }
    }
    ::close(connection);
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
  }
  return seen;
}

TEST_F(AtARocket, ABrowserSeesTheCanardsMoveAndTheSheetFill) {
  constexpr std::uint16_t port = 18080;
  const Folder folder;
  std::atomic<bool> stop = false;
  auto browser = std::async(std::launch::async, [&] { return seen_by_a_browser(port, stop); });
  const Outcome outcome = fantail_bench({"step", "--can", "vcan0", "--canard", "2", "--vehicle", "tasha3_bench",
                                         "--page-at", fmt::format("127.0.0.1:{}", port), "--out", folder / "sheet"});
  stop = true;
  const std::string seen = browser.get();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED2(contains, outcome.err, fmt::format("page: http://127.0.0.1:{}/\n", port));
  EXPECT_PRED2(contains, outcome.out, "\n  page   at most 1 viewer at the same time, ");
  EXPECT_PRED2(contains, seen, R"("now":"canard 2 alone: at once to one side")");
  EXPECT_PRED2(contains, seen, R"("sheet":")");
  EXPECT_PRED2(contains, seen, R"("ended":true)");
  EXPECT_PRED2(contains, seen, "PASS");
}

TEST_F(AtARocket, WithAnotherPlanNothingMoves) {
  Dump dump{"vcan0"};
  const Outcome outcome = fantail({"bench", "limits", "--can", "vcan0", "--plan", "tasha3_launch1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(
      outcome.err,
      "fantail: the plan in the rocket is not tasha3_launch1; send it with fantail bench plan tasha3_launch1 --can "
      "vcan0\n");
  EXPECT_EQ(outcome.out, "");
  for (const LoggedFrame& each : frames(dump.log())) {
    EXPECT_GE(each.frame.id, 0x100U) << "the bench has said something";
  }
}

// The canards have been centred by then; the exit code alone says that there is no sheet.
TEST_F(AtARocket, AFullDiskForTheSheetIsAnOutputFault) {
  const Folder folder;
  const auto full = [] {
    const rlimit none{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &none);
  };
  const Outcome outcome =
      fantail_bench({"step", "--can", "vcan0", "--canard", "1", "--out", folder / "sheet"}, {.prepare = full});
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_PRED2(contains, outcome.err, "sheet.html: File too large");
  EXPECT_TRUE(folder.listing().empty());
  Ear ear{"vcan0"};
  EXPECT_TRUE(ear.until([&] { return ear.link().newest<protocol::SessionReply>().has_value(); }));
  EXPECT_EQ(ear.newest<protocol::SessionReply>().reason, protocol::SessionReason::closed_by_bench);
}

}  // namespace

}  // namespace fantail::test
