// SPDX-License-Identifier: MIT
// A PC that is too busy for its programs, or was suspended: no sentence may blame the avionics for it.

#include "figures.hpp"
#include "link/arm_steps.hpp"
#include "link/place.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/plan_block.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using link::Timeout;

/// With the node on the same PC both sleep; a rocket on a real bus lives on, and the PC's socket keeps what it said.
enum class Asleep : std::uint8_t { both, bench_alone };

class BusyPc : public testing::TestWithParam<Asleep> {
 protected:
  void sleep(BenchAtWorld& place, hal::Microseconds time) const {
    if (GetParam() == Asleep::both) {
      place.suspend(time);
    } else {
      place.wait(time);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Sleeps, BusyPc, testing::Values(Asleep::both, Asleep::bench_alone),
                         [](const auto& one) { return one.param == Asleep::both ? "WithTheNode" : "Alone"; });

// The simulated socket keeps 64 frames, the oldest, as a real one keeps some hundreds.
TEST_P(BusyPc, ThatSleptDoesNotCallTheAvionicsSilent) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.pc_bus};
  link::await_avionics(place, link);
  for (int i = 0; i < 10; ++i) {
    sleep(place, 3 * second);
    (void)link.listen(place.now());
    EXPECT_FALSE(link.has_fallen_silent()) << i;
    place.wait(20 * millisecond);
    (void)link.listen(place.now());
    EXPECT_FALSE(link.has_fallen_silent()) << i;
  }
}

TEST(ABusyPc, ThatSleepsWithItsNodeInTheMiddleOfAnExerciseFinishesIt) {
  BenchAtWorld place{"bench_healthy"};
  int ticks = 0;
  place.after_tick = [&] {
    ticks += 1;
    if (ticks % 2'000 == 0) {
      place.suspend(3 * second);
    }
  };
  EXPECT_TRUE(place.limits().passed());
}

TEST_P(BusyPc, ThatSleepsInTheMiddleOfASelfTestHearsItsEnd) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.pc_bus};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  int replies = 0;
  const protocol::ArmReply reply = steps.run_self_test([&](const protocol::ArmReply&) {
    replies += 1;
    if (replies % 8 == 1) {
      sleep(place, 3 * second);
    }
  });
  EXPECT_EQ(reply.self_test, protocol::SelfTestState::passed);
}

TEST(ABusyPc, ThatHoldsTheBenchUpIsNamedWhenTheSessionIsLost) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.pc_bus};
  link::Session session = place.open_session(link);
  session.wait(second);
  place.wait(3 * second);  // the rocket lives on, and the bench does not speak
  try {
    session.wait(second);
    FAIL() << "the session is still open";
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "heartbeat") && says(error.what(), "this PC")) << error.what();
    EXPECT_EQ(figures(error.what()), (std::vector<std::string>{"0.1", "3.0"}));
  }
}

TEST(ABusyPc, ARocketThatDiesIsSilentAfterTwoSecondsOfListening) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.pc_bus};
  link::Session session = place.open_session(link);
  place.switch_off();
  const hal::Microseconds dead = place.now();
  try {
    session.wait(20 * second);
    FAIL() << "nobody noticed";
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "stopped")) << error.what();
  }
  EXPECT_NEAR(1e-6 * static_cast<double>((place.now() - dead).count()), 2.0, 0.05);
}

TEST(Timeout, CountsAQuarterOfASecondBetweenTwoLooksAtTheMost) {
  Timeout timeout{2 * second, 10 * second};
  hal::Microseconds now = 10 * second;
  int looks = 0;
  do {
    now += 60 * second;
    looks += 1;
  } while (!timeout.expired(now));
  EXPECT_EQ(looks, 8);
  timeout.restart();
  for (looks = 0; !timeout.expired(now); now += 100 * millisecond) {
    looks += 1;
  }
  EXPECT_EQ(looks, 20);
}

}  // namespace
}  // namespace fantail::sil
