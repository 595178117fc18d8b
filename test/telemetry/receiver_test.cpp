// SPDX-License-Identifier: MIT
#include "telemetry/receiver.hpp"

#include "test.hpp"

namespace fantail::telemetry {
namespace {

using hal::Microseconds;

constexpr Microseconds period{10'000};

/// A sender whose state number N has a roll angle of N radians, and a receiver that hears what it is given.
struct Ear {
  void hear_state(std::int64_t sequence, std::int64_t run = 1) { hear(state(sequence, run)); }
  void hear(const Packet& packet) { receiver.take(name(packet.channel), packet.content(), now); }
  static Packet state(std::int64_t sequence, std::int64_t run = 1) {
    return encode(Stamp{.run = run, .sequence = sequence, .time = sequence * period},
                  State{.roll_angle_rad = static_cast<double>(sequence)});
  }
  static Packet event(std::int64_t sequence, core::Phase phase) {
    return encode(Stamp{.run = 1, .sequence = sequence}, Event{.phase = Event::PhaseChange{.phase = phase}});
  }
  [[nodiscard]] std::optional<double> shown() const {
    return receiver.state() ? receiver.state()->content.roll_angle_rad : std::nullopt;
  }
  [[nodiscard]] const ChannelFigures& figures() const { return receiver.total(Channel::state); }

  Microseconds now{};
  Receiver receiver;
};

TEST(Receiver, AnOlderMessageNeverTakesThePlaceOfANewerOne) {
  Ear ear;
  for (const auto& [sequence, shown] :
       std::vector<std::pair<std::int64_t, double>>{{0, 0}, {1, 1}, {4, 4}, {2, 4}, {4, 4}, {3, 4}, {0, 4}}) {
    ear.hear_state(sequence);
    EXPECT_EQ(ear.shown(), shown) << sequence;
  }
  EXPECT_EQ(ear.figures(), (ChannelFigures{.received = 5, .lost = 0, .late = 2, .duplicate = 2}));
}

TEST(Receiver, OverABadLinkTheRollAngleShownOnlyEverRises) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random{seed};
    Ear ear;
    std::vector<std::int64_t> flying;
    double before = -1.0;
    for (std::int64_t sequence = 0; sequence < 3'000; ++sequence) {
      flying.push_back(sequence);
      if (random() % 10 == 0) {
        flying.push_back(sequence);
      }
      ear.now += period;
      // Some arrive now, in any order, some get lost, the others stay in the air.
      std::ranges::shuffle(flying, random);
      while (flying.size() > random() % 20) {
        if (random() % 10 != 0) {
          ear.hear_state(flying.back());
        }
        flying.pop_back();
        if (ear.shown()) {
          ASSERT_GE(*ear.shown(), before);
          before = *ear.shown();
        }
      }
    }
    EXPECT_EQ(ear.receiver.restarts(), 0);
    EXPECT_EQ(ear.figures().ignored, 0);
  }
}

TEST(Receiver, ALateEventIsStillToldAndInItsPlace) {
  Ear ear;
  ear.hear(Ear::event(0, core::Phase::armed));
  ear.hear(Ear::event(2, core::Phase::controlling));
  ear.hear(Ear::event(1, core::Phase::launched));
  ear.hear(Ear::event(1, core::Phase::launched));
  const auto events = ear.receiver.take_events();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].content.phase->phase, core::Phase::launched);
  EXPECT_EQ(events[2].content.phase->phase, core::Phase::controlling);
  EXPECT_TRUE(ear.receiver.take_events().empty());
}

TEST(Receiver, ASenderThatWasStartedAgainIsFollowedAtOnce) {
  Ear ear;
  ear.hear_state(500, 1);
  ear.hear_state(0, 2);
  EXPECT_EQ(ear.shown(), 0.0);
  EXPECT_EQ(ear.receiver.state()->stamp.run, 2);
  EXPECT_EQ(ear.receiver.restarts(), 1);
  // What the first one sent before it ended may still be on its way.
  ear.hear_state(501, 1);
  EXPECT_EQ(ear.shown(), 0.0);
  EXPECT_EQ(ear.figures().ignored, 1);
}

TEST(Receiver, OfTwoSendersAtOnceOneIsShownAndTheOtherCounted) {
  Ear ear;
  ear.hear_state(0, 1);
  for (std::int64_t i = 0; i < 1'000; ++i) {
    ear.hear_state(i, 2);
    ear.hear_state(i + 1, 1);
    EXPECT_EQ(ear.receiver.state()->stamp.run, 2);
  }
  EXPECT_EQ(ear.figures().ignored, 1'000);
  EXPECT_EQ(ear.receiver.restarts(), 1);
}

TEST(Receiver, ALogThatIsPlayedAgainIsFollowedAfterHalfASecond) {
  Ear ear;
  for (std::int64_t i = 0; i < 3'000; ++i) {
    ear.hear_state(i);
  }
  for (std::int64_t i = 0; i < Receiver::restart_after - 1; ++i) {
    ear.hear_state(i);
    EXPECT_EQ(ear.shown(), 2'999.0);
  }
  ear.hear_state(Receiver::restart_after - 1);
  EXPECT_EQ(ear.shown(), 49.0);
}

// All its numbers are in the window, so each one alone looks like one that came twice.
TEST(Receiver, SoIsAShortOneWhenThereWasSilenceBefore) {
  Ear ear;
  for (std::int64_t i = 0; i < 200; ++i) {
    ear.hear_state(i);
  }
  ear.now += Receiver::stale_after + Microseconds{1};
  for (std::int64_t i = 0; i < 200; ++i) {
    ear.hear_state(i);
  }
  EXPECT_EQ(ear.shown(), 199.0);
  EXPECT_EQ(ear.receiver.restarts(), 1);
  EXPECT_EQ(ear.receiver.state()->came, ear.now);
}

TEST(Receiver, WhatCannotBeReadIsCountedAndOtherChannelsAreNot) {
  Ear ear;
  Packet packet = Ear::state(0);
  packet.size -= 1;
  ear.hear(packet);
  ear.receiver.take("POSE", packet.content(), ear.now);
  EXPECT_EQ(ear.figures(), (ChannelFigures{.unreadable = 1}));
  EXPECT_EQ(ear.shown(), std::nullopt);
}

// 100 a second, every tenth is lost: 90 received and 10 lost in each second.
TEST(Receiver, TheRecentFiguresAreThoseOfTheLastFiveSeconds) {
  Ear ear;
  std::int64_t sequence = 0;
  for (int second = 0; second < 12; ++second) {
    for (int i = 0; i < 100; ++i, ++sequence) {
      ear.now += period;
      if (sequence % 10 != 5) {
        ear.hear_state(sequence);
      }
    }
    ear.receiver.look(ear.now);
  }
  EXPECT_EQ(ear.receiver.recent_span(), Receiver::recent_time);
  EXPECT_EQ(ear.receiver.recent(Channel::state), (ChannelFigures{.received = 450, .lost = 50}));
  EXPECT_EQ(ear.receiver.total(Channel::state), (ChannelFigures{.received = 1'080, .lost = 120}));
}

}  // namespace
}  // namespace fantail::telemetry
