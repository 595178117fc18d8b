// SPDX-License-Identifier: MIT
// Two bench programs at one rocket, as far as a program goes without its process.
#include <gtest/gtest.h>

#include "avionics/can_frame.hpp"
#include "protocol/bus_codec.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

/// A second PC on the bus of the first: it has a socket of its own, and the same time passes for both.
class BesideIt final : public link::Place {
 public:
  explicit BesideIt(BenchAtWorld& first) : first_{first}, bus_{first.wire} {}
  [[nodiscard]] hal::CanBus& bus() override { return bus_; }
  [[nodiscard]] hal::Microseconds now() const override { return first_.now(); }
  void wait(hal::Microseconds at_most) override { first_.wait(at_most); }

 private:
  BenchAtWorld& first_;
  hal::sim::CanBus bus_;
};

/// Frames that the bench side of the bus carried.
int said_by_benches(hal::sim::CanBus& ear) {
  int frames = 0;
  while (const auto frame = ear.receive()) {
    frames += frame->id < 0x100 ? 1 : 0;
  }
  return frames;
}

std::string refusal_of_a_session(link::Place& place, link::AvionicsLink& link, std::uint16_t number) {
  try {
    const link::Session session{place, link, number};
  } catch (const link::LinkError& error) {
    return error.what();
  }
  return "it was opened";
}

/// A rocket at rest, and a second bench that has heard it.
class TwoBenches : public testing::Test {
 protected:
  void SetUp() override {
    place.wait(4 * second);
    link::await_avionics(beside, link);
  }

  BenchAtWorld place{"bench_healthy"};
  BesideIt beside{place};
  link::AvionicsLink link{beside.bus()};
  protocol::FrameCounter counter;
};

TEST_F(TwoBenches, TheSecondLooksBeforeItAsksAndSaysThatAnotherHasTheSession) {
  // The first one, which lives while the second one waits.
  hal::sim::CanBus first{place.wire};
  int ticks = 0;
  place.after_tick = [&] {
    if (ticks++ % 20 == 0) {
      const auto action = ticks == 1 ? protocol::SessionAction::open : protocol::SessionAction::keep;
      (void)first.send(
          avionics::can_frame(encode(protocol::BenchSession{.action = action, .session = 3}, counter.next())));
    }
  };
  place.wait(100 * millisecond);
  hal::sim::CanBus ear{place.wire};
  EXPECT_EQ(refusal_of_a_session(beside, link, 6),
            "another bench has the session; end that one, or wait until it has ended");
  EXPECT_LE(said_by_benches(ear), 3) << "more than the heartbeats of the first";

  place.after_tick = nullptr;
  place.wait(200 * millisecond);
  EXPECT_EQ(refusal_of_a_session(beside, link, 6), "it was opened");
}

TEST_F(TwoBenches, OfTwoThatAskInTheSameMillisecondOneGetsTheSessionAndTheOtherIsToldSo) {
  hal::sim::CanBus rival{place.wire};
  hal::sim::CanBus ear{place.wire};
  int since_the_look = 0;
  place.after_tick = [&] {
    while (const auto frame = ear.receive()) {
      since_the_look += frame->id == 0x110 && since_the_look == 0 ? 1 : 0;  // by its status the rocket is free
    }
    if (since_the_look > 0 && since_the_look++ % 20 == 1) {
      const auto action = since_the_look == 2 ? protocol::SessionAction::open : protocol::SessionAction::keep;
      (void)rival.send(
          avionics::can_frame(encode(protocol::BenchSession{.action = action, .session = 3}, counter.next())));
    }
  };
  EXPECT_EQ(refusal_of_a_session(beside, link, 6),
            "another bench has the session; end that one, or wait until it has ended");
}

TEST(TwoSessions, ANumberThatIsTooSimilarToTheOneBeforeIsReplacedByTheBenchItself) {
  std::uint16_t similar = 6;
  while (protocol::told_apart(5, similar)) {
    similar += 1;
  }
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  {
    link::Session session = place.open_session(link);
    ASSERT_EQ(session.number(), 5);
    EXPECT_TRUE(session.close());
  }
  link::Session session{place, link, similar};
  EXPECT_TRUE(protocol::told_apart(5, session.number()));
  session.request({core::Angle::from_degrees(5), {}, {}, {}});
  session.wait(second);
  EXPECT_NEAR(place.record.canards[0].angle.degrees(), 5.0F, 0.01F);
}

}  // namespace
}  // namespace fantail::sil
