// SPDX-License-Identifier: MIT
// Two rockets on one bus: every verb says so and does nothing more.
#include <cstdio>

#include "can/rig.hpp"

namespace fantail::test {
namespace {

constexpr const char* told = "two rockets, or a device that imitates one, report on this bus";

// Again where a busy machine kept one of the two nodes silent for as long as the verb listened.
Outcome until_told(const std::vector<std::string>& verb) {
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), verb.begin(), verb.end());
  words.insert(words.end(), {"--can", "vcan0"});
  Outcome outcome = fantail(words);
  for (int again = 0; again < 11 && !contains(outcome.err, told); ++again) {
    std::printf("%s did not hear both nodes, once more: %s", verb[0].c_str(), outcome.err.c_str());
    outcome = fantail(words);
  }
  return outcome;
}

TEST_F(CanSystem, EveryVerbNamesASecondRocketAndStops) {
  Node one{"vcan0"};
  one.await_rest();
  Node other{"vcan0", "bench_canard3_reversed"};
  ASSERT_TRUE(other.program.says(" on vcan0;"));
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.until([&] { return ear.link().two_rockets().has_value(); }));
  const Folder folder;
  const std::string out = folder / "out";
  for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{{"watch", "--for", "20"},
                                                                                    {"watch", "--json", "--for", "20"},
                                                                                    {"limits", "--out", out},
                                                                                    {"cycle", "--out", out},
                                                                                    {"hold", "1", "2", "--for", "20"},
                                                                                    {"zero"},
                                                                                    {"axes"},
                                                                                    {"arm", "--yes"},
                                                                                    {"plan", "tasha3_launch2"},
                                                                                    {"plan", "show"},
                                                                                    {"log", "--out", out}}) {
    const Outcome outcome = until_told(verb);
    EXPECT_EQ(outcome.exit_code, 74) << verb[0] << ": " << outcome.out;
    EXPECT_PRED2(contains, outcome.err, told) << verb[0];
  }
}

}  // namespace
}  // namespace fantail::test
