// SPDX-License-Identifier: MIT
// Two bench programs at one rocket: one session is one sender's.
#include "can/rig.hpp"

namespace fantail::test {
namespace {

TEST_F(CanSystem, ASecondBenchIsSentAwayAndTheFirstEndsItsWork) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  const Folder folder;
  const auto step = [&](const std::string& out) {
    return std::vector<std::string>{"bench", "step", "--can", "vcan0", "--canard", "2", "--to", "-5", "--out", out};
  };
  Outcome first;
  int sent_away = 0;
  for (int again = 0; again < 12; ++again) {
    Program limits{{"bench", "limits", "--can", "vcan0", "--out", folder / "limits"}};
    if (!ear.until([&] { return farthest_deg(ear.newest<protocol::CommandReport>().angle) > 1.0F; })) {
      first = limits.outcome();
      ASSERT_TRUE(starved(first)) << first.out << first.err;
      continue;
    }
    const std::uint16_t session = ear.newest<protocol::SessionReply>().session;
    for (int i = 0; i < 4 && !limits.ended(); ++i) {
      const Outcome second = fantail(step(folder / "second"));
      if (ear.until([&] { return !limits.ended(); }, std::chrono::milliseconds{1})) {
        EXPECT_EQ(second.exit_code, 74) << second.out;
        EXPECT_EQ(second.err, "fantail: another bench has the session; end that one, or wait until it has ended\n");
        EXPECT_EQ(ear.newest<protocol::SessionReply>().session, session);
        sent_away += 1;
      }
    }
    first = limits.outcome();
    if (!starved(first)) {
      break;
    }
  }
  EXPECT_EQ(first.exit_code, 0) << first.out << first.err;
  EXPECT_GE(sent_away, 3);
  const Folder after;
  const Outcome last = fantail_bench({"step", "--can", "vcan0", "--canard", "2", "--out", after / "sheet"});
  EXPECT_EQ(last.exit_code, 0) << last.out << last.err;
}

}  // namespace
}  // namespace fantail::test
