// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

Outcome dormancy(const std::vector<std::string>& more) {
  std::vector<std::string> words{"bench", "dormancy", "--can", "vcan0"};
  words.insert(words.end(), more.begin(), more.end());
  return fantail(words);
}

struct Dormancy : CanSystem {
  Node node{"vcan0"};
  Ear ear{"vcan0"};
  void SetUp() override {
    CanSystem::SetUp();
    node.await_rest();
  }
  [[nodiscard]] std::string block_crc() {
    const std::uint64_t seen = ear.link().count<protocol::HeartbeatReport>();
    EXPECT_TRUE(ear.until([&] { return ear.link().count<protocol::HeartbeatReport>() > seen; }));
    return fmt::format("{:08x}", ear.newest<protocol::HeartbeatReport>().plan_crc);
  }
  /// Reports from before a change wait in the queue of the socket until somebody listens.
  [[nodiscard]] bool comes_to_name(const std::string& crc) {
    return ear.until([&] { return fmt::format("{:08x}", ear.newest<protocol::HeartbeatReport>().plan_crc) == crc; });
  }
};

TEST_F(Dormancy, IsShownThenSetWithOldAndNewValuesAndStandsOnTheSheet) {
  const std::string old_crc = block_crc();
  const Outcome shown = dormancy({});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_PRED2(contains, shown.out, "Canards stay at trim until clear of the guide.\n  until              \"guide\"\n");
  EXPECT_PRED2(contains, shown.out, old_crc + "\n  plan               the built-in one; none is stored\n");
  EXPECT_EQ(block_crc(), old_crc);

  const Outcome set = dormancy({"--until", "height", "--height-m", "1700"});
  EXPECT_EQ(set.exit_code, 0) << set.err;
  const std::string label = "  block_crc          ";
  ASSERT_PRED2(contains, set.out, label);
  const std::string new_crc = set.out.substr(set.out.find(label) + label.size(), 8);
  EXPECT_NE(new_crc, old_crc);
  EXPECT_TRUE(comes_to_name(new_crc));
  EXPECT_PRED2(contains, set.out,
               "The changed plan is in force: canards stay at trim until 1700 m above the launch site.\n"
               "  until              \"height\" (was \"guide\")\n  height_m           1700 (was 1500)\n");
  EXPECT_PRED2(contains, set.out, fmt::format("  block_crc          {} (was {})\n", new_crc, old_crc));
  EXPECT_PRED2(contains, set.out, "Run the self-test again: fantail bench arm --can vcan0.");
  const Outcome plan = fantail_bench({"plan", "show", "--can", "vcan0"});
  const Outcome built_in = fantail({"plan", "show", "tasha3_launch2"});
  EXPECT_PRED2(contains, plan.out, "height_m = 1700 ");
  EXPECT_EQ(std::ranges::count(plan.out, '\n'), std::ranges::count(built_in.out, '\n'));

  const Folder folder;
  const Outcome step = fantail_bench({"step", "--can", "vcan0", "--canard", "1", "--json", "--out", folder / "sheet"});
  EXPECT_EQ(json::parse(step.out)["gate"], "1700 m above the launch site") << step.err;
  EXPECT_EQ(json::parse(step.out)["plan_crc"], new_crc);
  EXPECT_PRED2(contains, content(folder / "sheet/sheet.html"), "1700 m above the launch site");
}

TEST_F(Dormancy, ThatIsSetAlreadyIsNotSentAgain) {
  ASSERT_EQ(dormancy({"--until", "max_dynamic_pressure"}).exit_code, 0);
  node.await_rest();
  const json::Value again = json::parse(dormancy({"--until", "max_dynamic_pressure", "--json"}).out);
  EXPECT_EQ(again["sent"], false);
  EXPECT_EQ(again["answer"], "yes");
  EXPECT_EQ(again["origin_before"], "stored");
  EXPECT_EQ(again["block_crc"], again["block_crc_before"]);
  EXPECT_EQ(again["dormancy"]["until"], "max_dynamic_pressure");
  EXPECT_TRUE(comes_to_name(again["block_crc"].text()));
}

TEST_F(Dormancy, ThatNoPlanCanHaveIsRefusedAndNothingIsSent) {
  const std::string before = block_crc();
  const Outcome low = dormancy({"--height-m", "0.2"});
  EXPECT_EQ(low.exit_code, 64);
  EXPECT_PRED2(contains, low.err, "--height-m: \"0.2\": allowed: 1 to 30000");
  EXPECT_EQ(dormancy({"--until", "never"}).exit_code, 64);
  const Outcome untimed = dormancy({"--until", "burn_out"});
  EXPECT_EQ(untimed.exit_code, 78);
  EXPECT_EQ(untimed.err,
            "fantail: nothing was sent: dormancy.burn_time_s = 0 is refused: must be above 0 with a gate by burn-out: "
            "the burn time of the motor\n");
  const Outcome in_guide = dormancy({"--until", "height", "--height-m", "5"});
  EXPECT_EQ(in_guide.exit_code, 78);
  EXPECT_PRED2(contains, in_guide.err, "nothing was sent: dormancy.height_m = 5 is refused: ");
  EXPECT_EQ(block_crc(), before);
}

}  // namespace
}  // namespace fantail::test
