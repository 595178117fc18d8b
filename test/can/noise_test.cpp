// SPDX-License-Identifier: MIT
#include <cmath>
#include <csignal>
#include <numeric>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

// Random identifiers, lengths and bytes beside the bench, as from other devices on the bus and from broken ones: 500 a
// second. With 2000 the guest would be busy with them alone.
TEST_F(CanSystem, ABusFullOfOthersFramesNeitherMovesACanardNorDisturbsTheBench) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.until([&] { return ear.link().newest<protocol::LimitReport>().has_value(); }));
  const auto limits = ear.newest<protocol::LimitReport>().limit;
  Dump dump{"vcan0"};
  const auto noise = [](const std::vector<std::string>& kind) {
    std::vector<std::string> words{"vcan0", "-g", "4", "-n", "2000", "-i"};
    words.insert(words.end(), kind.begin(), kind.end());
    return std::make_unique<Program>("cangen", words);
  };
  const auto others = {noise({}), noise({"-m"})};  // -m: extended, remote and CAN FD too
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const Folder folder;
  const Outcome step = fantail_bench(
      {"step", "--can", "vcan0", "--canard", "1", "--vehicle", "tasha3_bench", "--out", folder / "sheet"});
  EXPECT_EQ(step.exit_code, 0) << step.out << step.err;
  for (const auto& other : others) {
    EXPECT_EQ(other->outcome().exit_code, 0) << other->outcome().err;
  }
  ASSERT_TRUE(ear.until([&] {
    const auto counts = ear.newest<protocol::RejectionReport>().count;
    return std::accumulate(counts.begin(), counts.end(), 0) > 0;
  }));
  const std::size_t seen = watch.said().size();
  EXPECT_TRUE(eventually([&] { return watch.said().size() > seen + 3000; }));
  watch.signal(SIGINT);

  const std::string said = watch.outcome().out;
  const std::size_t last = said.rfind('\n', said.size() - 2);
  const Json object = json::parse(said.substr(last == std::string::npos ? 0 : last + 1));
  EXPECT_GT(object["frames_foreign"].number(), 1000);
  EXPECT_GT(object["frames_damaged"].number(), 0);
  const auto& rejected = object["frames_refused_by_avionics"];
  EXPECT_GT(rejected["unknown_id"].number(), 0);
  EXPECT_GT(rejected["wrong_length"].number(), 0);

  const std::string log = dump.log();
  float farthest = 0.0F;
  for (const auto& command : reports<protocol::CommandReport>(log)) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      EXPECT_LE(std::fabs(command.angle[i].value_or(core::Angle{}).degrees()), limits[i].degrees());
      EXPECT_TRUE(i == 0 || command.angle[i].value_or(core::Angle{}).degrees() == 0.0F) << "canard " << i + 1;
    }
    farthest = std::max(farthest, farthest_deg(command.angle));
  }
  EXPECT_NEAR(farthest, 5.0F, 0.005F) << "what the bench asked for";
}

}  // namespace
}  // namespace fantail::test
