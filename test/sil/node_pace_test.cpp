// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include "figures.hpp"
#include "fly/pace.hpp"
#include "test.hpp"

namespace fantail::fly {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

const Pace::Time power_up{seconds{100}};

/// A PC that needs `cost` for each tick; the messages of its node, and how many ticks it had gone through by then.
struct Pc {
  Pace pace{power_up};
  Pace::Time now = power_up;
  int ticks = 0;
  std::string messages;

  void run_for(Pace::Duration time, Pace::Duration cost) {
    for (const Pace::Time end = now + time; now < end; ++ticks) {
      now = std::max(now, pace.next(now)) + cost;
      messages += pace.take_messages();
    }
  }
  [[nodiscard]] double lived_s() const { return 1e-3 * ticks; }
};

TEST(NodePace, OnAPcThatKeepsUpATickBeginsEveryMillisecond) {
  Pc pc;
  pc.run_for(seconds{20}, microseconds{700});
  EXPECT_NEAR(pc.ticks, 20'000, 1);
  EXPECT_EQ(pc.pace.late(), 0);
  EXPECT_EQ(pc.pace.left_out().count(), 0);
  EXPECT_EQ(pc.messages, "");
}

TEST(NodePace, TenMillisecondsAreMadeUpForAndMoreIsLeftOut) {
  Pc pc;
  pc.run_for(milliseconds{100}, milliseconds{0});
  pc.now += milliseconds{10};
  pc.run_for(milliseconds{100}, milliseconds{0});
  EXPECT_NEAR(pc.lived_s(), 0.210, 0.0015);
  EXPECT_EQ(pc.pace.left_out().count(), 0);
  EXPECT_NEAR(static_cast<double>(pc.pace.late()), 10.0, 1.0);
  pc.now += milliseconds{50};
  pc.run_for(milliseconds{100}, milliseconds{0});
  EXPECT_NEAR(pc.lived_s(), 0.310, 0.0025);
  EXPECT_GE(pc.pace.left_out(), milliseconds{49});
  EXPECT_LE(pc.pace.left_out(), milliseconds{52});
  EXPECT_EQ(pc.pace.ticks_left_out(), pc.pace.left_out() / milliseconds{1});
  EXPECT_EQ(pc.messages, "");
}

// A hundred ticks without a pause would be the end of a bench session whose heartbeats could not come.
TEST(NodePace, NoMoreThanElevenTicksAreLivedThroughWithoutAPause) {
  for (const int gap_ms : {1, 5, 9, 10, 11, 12, 50, 99, 100, 5'000}) {
    Pace pace{power_up};
    const Pace::Time now = power_up + milliseconds{gap_ms};
    int at_once = 0;
    while (pace.next(now) <= now) {
      at_once += 1;
    }
    EXPECT_LE(at_once, 11) << gap_ms;
  }
}

TEST(NodePace, ALongStandstillIsToldOnce) {
  Pc pc;
  pc.run_for(seconds{2}, microseconds{100});
  pc.now += seconds{40};
  pc.run_for(seconds{30}, microseconds{100});
  EXPECT_EQ(figures(pc.messages), std::vector<std::string>{"40.0"});
}

TEST(NodePace, APcThatIsTooSlowIsToldHowSlowTheRocketLivesAndWhatItSaysIsSo) {
  for (const int cost_us : {2'300, 4'000, 30'000, 200'000}) {
    Pc pc;
    pc.run_for(seconds{5}, microseconds{cost_us});
    while (pc.messages.empty() && pc.ticks < 100'000) {
      pc.run_for(microseconds{1}, microseconds{cost_us});
    }
    const double passed_s = std::chrono::duration<double>{pc.now - power_up}.count() - 1e-6 * cost_us;
    EXPECT_EQ(figures(pc.messages),
              (std::vector{fmt::format("{:.1f}", passed_s), fmt::format("{:.1f}", pc.lived_s())}));
    pc.messages.clear();
    pc.run_for(seconds{20}, microseconds{700});
    EXPECT_EQ(pc.messages, "") << "it has caught up";
  }
}

TEST(NodePace, StandstillsThatComeAgainAndAgainAreAMatterOfPace) {
  Pc pc;
  for (int i = 0; i < 6; ++i) {
    pc.now += milliseconds{1'200};
    pc.run_for(milliseconds{300}, microseconds{100});
  }
  const std::vector<std::string> said = figures(pc.messages);
  EXPECT_NE(std::ranges::find(said, "1.2"), said.end()) << pc.messages;
  EXPECT_TRUE(std::ranges::any_of(said, [](const auto& of_last_s) { return of_last_s.starts_with("5"); }))
      << pc.messages;
}

TEST(NodePace, APcThatIsALittleTooSlowIsNotWorthAWord) {
  Pc pc;
  pc.run_for(seconds{30}, microseconds{1'800});
  EXPECT_EQ(pc.messages, "");
  EXPECT_GT(pc.pace.left_out(), seconds{10});
}

}  // namespace
}  // namespace fantail::fly
