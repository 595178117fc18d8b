// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

std::string plan_in_force(const std::string& interface) {
  const Outcome watch = fantail({"bench", "watch", "--can", interface, "--json", "--for", "1"});
  return json::parse(watch.out)["plan_crc"].text();
}

// A block ends with its CRC-32C, the low byte first.
std::string checksum_of(const std::string& block) {
  std::uint32_t checksum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    checksum |= std::uint32_t{static_cast<unsigned char>(block[block.size() - 4 + i])} << (8 * i);
  }
  return fmt::format("{:08x}", checksum);
}

TEST_F(CanSystem, APlanIsStoredAndStaysInForceAndABrokenOneIsRefused) {
  const Folder folder;
  const std::string flash = folder / "flash.bin";
  ASSERT_EQ(fantail({"plan", "compile", "tunnel_steps", "--out", folder / "tunnel.ftpl"}).exit_code, 0);
  const std::string block = content(folder / "tunnel.ftpl");
  const std::string wanted = checksum_of(block);
  {
    Node node{"vcan0", "bench_healthy", flash};
    node.await_rest();
    const std::string before = plan_in_force("vcan0");
    EXPECT_NE(before, wanted);

    std::string broken = block;
    broken[broken.size() / 2] ^= 4;
    const std::string file = folder.write("broken.ftpl", broken);
    const Outcome refused = fantail({"bench", "plan", file, "--can", "vcan0", "--json"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_EQ(refused.err,
              "fantail: the avionics refuses " + file + ": its checksum is wrong; its old plan stays in force\n");
    EXPECT_EQ(json::parse(refused.out)["refused_because"], "its checksum is wrong");
    EXPECT_EQ(plan_in_force("vcan0"), before);

    const Outcome stored = fantail({"bench", "plan", "tunnel_steps", "--can", "vcan0"});
    EXPECT_EQ(stored.exit_code, 0) << stored.err;
    EXPECT_PRED2(contains, stored.out, "tunnel_steps: " + std::to_string(block.size()) + " bytes sent");
    EXPECT_EQ(plan_in_force("vcan0"), wanted);
    node.program.type("quit");
    EXPECT_EQ(node.program.outcome().exit_code, 0);
  }
  Node again{"vcan0", "bench_healthy", flash};
  again.await_rest();
  EXPECT_EQ(plan_in_force("vcan0"), wanted);
}

}  // namespace
}  // namespace fantail::test
