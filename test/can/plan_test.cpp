// SPDX-License-Identifier: MIT
#include <fmt/core.h>

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
  EXPECT_EQ(stored.out, "in force: " + wanted + "\nread back: the same 504 bytes\n");
  EXPECT_TRUE(ear.until([&] {
    return fmt::format("{:08x}", ear.newest<protocol::HeartbeatReport>().plan_crc) == wanted &&
           ear.newest<protocol::BoardReport>().plan == protocol::PlanSource::stored;
  }));
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

}  // namespace
}  // namespace fantail::test
