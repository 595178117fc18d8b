// SPDX-License-Identifier: MIT
// Two rockets on one bus: every verb says so and does nothing more.
#include "can/rig.hpp"

namespace fantail::test {
namespace {

TEST_F(CanSystem, EveryVerbNamesASecondRocketAndStops) {
  Node one{"vcan0"};
  one.await_rest();
  Node other{"vcan0", "bench_canard3_reversed"};
  ASSERT_TRUE(other.program.says(" on vcan0;"));
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.until([&] { return ear.link().two_rockets().has_value(); }));
  const Folder folder;
  const std::string out = folder / "out";
  for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{{"watch"},
                                                                                    {"watch", "--json"},
                                                                                    {"limits", "--out", out},
                                                                                    {"cycle", "--out", out},
                                                                                    {"hold", "1", "2"},
                                                                                    {"zero"},
                                                                                    {"axes"},
                                                                                    {"arm", "--yes"},
                                                                                    {"plan", "tasha3_launch2"},
                                                                                    {"plan", "show"},
                                                                                    {"log", "--out", out}}) {
    std::vector<std::string> words{"bench"};
    words.insert(words.end(), verb.begin(), verb.end());
    words.insert(words.end(), {"--can", "vcan0"});
    const Outcome outcome = fantail(words);
    EXPECT_EQ(outcome.exit_code, 74) << verb[0] << ": " << outcome.out;
    EXPECT_PRED2(contains, outcome.err, "two rockets, or a device that imitates one, report on this bus") << verb[0];
  }
  EXPECT_EQ(farthest_deg(ear.newest<protocol::CommandReport>().angle), 0.0F);
}

}  // namespace
}  // namespace fantail::test
