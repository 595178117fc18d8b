// SPDX-License-Identifier: MIT
// Two bench programs at one rocket: one session is one sender's.
#include "can/rig.hpp"

namespace fantail::test {
namespace {

const std::string another_has_the_session =
    "fantail: another bench has the session; end that one, or wait until it has ended\n";

// Because a busy machine kept it silent: were it not so every time, the first bench would never end its work.
bool has_lost_its_session(const Outcome& outcome) {
  return outcome.exit_code == 74 && outcome.err == another_has_the_session;
}

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
      ASSERT_TRUE(starved(first) || has_lost_its_session(first)) << first.out << first.err;
      continue;
    }
    const std::uint16_t session = ear.newest<protocol::SessionReply>().session;
    std::vector<Outcome> seconds;
    bool session_stayed = true;
    for (int i = 0; i < 4 && !limits.ended(); ++i) {
      const Outcome second = fantail(step(folder / "second"));
      if (ear.until([&] { return !limits.ended(); }, std::chrono::milliseconds{1})) {
        seconds.push_back(second);
        session_stayed = session_stayed && ear.newest<protocol::SessionReply>().session == session;
      }
    }
    first = limits.outcome();
    if (starved(first) || has_lost_its_session(first)) {
      continue;  // a bench that is silent too long gives way to the next
    }
    EXPECT_TRUE(session_stayed);
    for (const Outcome& second : seconds) {
      EXPECT_EQ(second.exit_code, 74) << second.out;
      EXPECT_EQ(second.err, another_has_the_session);
      sent_away += 1;
    }
    break;
  }
  EXPECT_EQ(first.exit_code, 0) << first.out << first.err;
  EXPECT_GE(sent_away, 3);
  const Folder after;
  const Outcome last = fantail_bench({"step", "--can", "vcan0", "--canard", "2", "--out", after / "sheet"});
  EXPECT_EQ(last.exit_code, 0) << last.out << last.err;
}

}  // namespace
}  // namespace fantail::test
