// SPDX-License-Identifier: MIT

#include "avionics/board_rig.hpp"
#include "avionics/bus_receiver.hpp"
#include "avionics/can_frame.hpp"
#include "hal/sim/can_bus.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using protocol::Rejection;

hal::CanFrame heartbeat(std::uint8_t counter) {
  return can_frame(encode(protocol::BenchSession{.action = protocol::SessionAction::keep, .session = 7}, counter));
}

class Receiver : public testing::Test {
 protected:
  int messages_of_a_tick() {
    int messages = 0;
    receiver.begin_tick();
    while (receiver.next(now, board, session)) {
      messages += 1;
    }
    return messages;
  }
  int rejected(Rejection cause) { return receiver.rejections().count[static_cast<std::size_t>(cause)]; }

  hal::sim::CanWire wire;
  hal::sim::CanBus board{wire};
  hal::sim::CanBus pc{wire};
  BusReceiver receiver;
  core::Microseconds now{};
  std::optional<std::uint16_t> session = 7;
};

TEST_F(Receiver, AnExtendedFrameWithTheIdentifierOfABenchIsUnknown) {
  hal::CanFrame frame = heartbeat(0);
  frame.extended = true;
  (void)pc.send(frame);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::unknown_id), 1);
}

TEST_F(Receiver, ARemoteFrameHasNoBytesWhateverLengthItAsksFor) {
  hal::CanFrame frame = heartbeat(0);
  frame.remote = true;
  (void)pc.send(frame);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_length), 1);
}

TEST_F(Receiver, GoodFramesTooHaveAShareOfTheTickAndTheRestComesInTheNext) {
  for (int i = 0; i < 30; ++i) {
    (void)pc.send(heartbeat(static_cast<std::uint8_t>(i % 16)));
  }
  EXPECT_EQ(messages_of_a_tick(), BusReceiver::most_frames_per_tick);
  EXPECT_EQ(messages_of_a_tick(), 30 - BusReceiver::most_frames_per_tick);
}

TEST_F(Receiver, AFrameOutsideOfSessionsIsRefusedOnlyWhenTheSameHasJustCome) {
  const auto begin = [](std::uint8_t counter) {
    return can_frame(encode(protocol::ArmRequest{.action = protocol::ArmAction::begin}, counter));
  };
  for (const auto counter : std::to_array<std::uint8_t>({3, 9, 2, 3})) {  // as two benches count
    (void)pc.send(begin(counter));
    EXPECT_EQ(messages_of_a_tick(), 1) << int{counter};
  }
  (void)pc.send(begin(3));
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_counter), 1);
  now += core::Microseconds{100'001};
  (void)pc.send(begin(3));
  EXPECT_EQ(messages_of_a_tick(), 1);
}

TEST_F(Receiver, ARequestWithoutASessionIsStaleAndForAnotherOneItHasAWrongChecksum) {
  const auto request = can_frame(encode(protocol::BenchRequest{}, 0, 7));
  session.reset();
  (void)pc.send(request);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::stale), 1);
  session = 8;
  (void)pc.send(request);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_crc), 1);
}

// Two benches on one bus, in lock-step with the avionics: one session is one sender's.

using namespace core::literals;
using protocol::SessionAction;
using protocol::SessionReason;
using protocol::SessionReply;

constexpr std::uint16_t first_session = 7;
constexpr std::uint16_t second_session = 8;
constexpr unsigned counters = 16;

protocol::BenchRequest ask(core::Angle angle) { return {.angle = {angle, angle, angle, angle}}; }

/// A rocket with two benches. The first has its session open and asks for 5 degrees; the second begins with its
/// counters at any value.
struct TwoBenches {
  explicit TwoBenches(unsigned offset) {
    rig.open_session(first_session);
    rig.heartbeat.reset();  // this test keeps the pace of both benches itself
    for (unsigned i = 0; i < offset; ++i) {
      second.skip_a_counter();
    }
  }

  /// Both at work: the first as a bench does it, a heartbeat every 20 ms and a request every 5 ms; the second sends
  /// `action` and a request for -5 degrees every `period` ticks.
  void run(int ticks, SessionAction action, int period) {
    for (int i = 0; i < ticks; ++i) {
      if (first_is_alive && i % 20 == 0) {
        rig.pc.say(protocol::BenchSession{.action = SessionAction::keep, .session = first_session});
      }
      if (first_asks && i % 5 == 0) {
        rig.pc.say(ask(5_deg));
      }
      if (i % period == 0) {
        second.say(protocol::BenchSession{.action = action, .session = second_session});
      }
      if (second_asks && i % period == 0) {
        second.say(ask(-5_deg));
      }
      rig.tick();
      const auto& reply = rig.pc.heard<SessionReply>();
      refusals += reply && reply->reason == SessionReason::other_session && reply->session == second_session ? 1 : 0;
      largest_deg = std::max(largest_deg, rig.commanded_deg(0));
      smallest_deg = std::min(smallest_deg, rig.commanded_deg(0));
    }
  }
  void forget_angles() { largest_deg = smallest_deg = 0.0; }
  [[nodiscard]] int rejected(protocol::Rejection cause) const {
    return rig.pc.heard<protocol::RejectionReport>()->count[static_cast<std::size_t>(cause)];
  }

  BoardRig rig;
  PcOnBus second{rig.wire};
  bool first_is_alive = true;
  bool first_asks = true;
  bool second_asks = false;
  int refusals = 0;
  double largest_deg = 0.0;
  double smallest_deg = 0.0;
};

class AtEveryRate : public testing::TestWithParam<int> {};

TEST_P(AtEveryRate, OpensOfASecondBenchAreRefusedAndDisturbTheFirstAtNoOffsetOfItsCounters) {
  for (unsigned offset = 0; offset < counters; ++offset) {
    TwoBenches both{offset};
    both.run(1'500, SessionAction::open, GetParam());
    EXPECT_TRUE(both.rig.all_pulses_are(5.0)) << offset;
    EXPECT_TRUE(both.rig.pc.heard<protocol::StatusReport>()->session_open) << offset;
    EXPECT_GE(both.refusals, 1'500 / std::max(GetParam(), 100)) << offset;
    EXPECT_EQ(both.rejected(protocol::Rejection::wrong_counter), 0) << offset;
  }
}

TEST_P(AtEveryRate, FramesForAnotherSessionMoveNothingAndKeepNothingAlive) {
  for (const SessionAction action : {SessionAction::keep, SessionAction::close}) {
    for (unsigned offset = 0; offset < counters; ++offset) {
      TwoBenches both{offset};
      both.second_asks = true;
      both.run(500, action, GetParam());
      EXPECT_TRUE(both.rig.all_pulses_are(5.0)) << offset;
      EXPECT_GE(both.smallest_deg, -0.01) << offset;
      both.first_is_alive = false;
      both.first_asks = false;
      both.run(102, action, GetParam());
      EXPECT_FALSE(both.rig.pc.heard<SessionReply>()->state == protocol::SessionState::open) << offset;
      EXPECT_TRUE(both.rig.all_pulses_are(0.0)) << offset;
    }
  }
}

TEST_P(AtEveryRate, TheRequestsOfABenchWhoseSessionHasEndedAreNotObeyedInsideTheNextOne) {
  for (unsigned offset = 0; offset < counters; ++offset) {
    TwoBenches both{offset};
    both.second_asks = true;
    both.run(200, SessionAction::open, GetParam());
    EXPECT_TRUE(both.rig.all_pulses_are(5.0)) << offset;
    both.first_is_alive = false;  // its heartbeats are lost, and it has not noticed yet
    both.run(300, SessionAction::open, GetParam());
    both.forget_angles();
    both.run(300, SessionAction::open, GetParam());
    EXPECT_EQ(both.rig.pc.heard<SessionReply>()->session, second_session) << offset;
    EXPECT_NEAR(both.largest_deg, 0.0, 0.0) << offset << ": a request of the first was obeyed";
    EXPECT_TRUE(both.rig.all_pulses_are(-5.0)) << offset;
  }
}

// The first one has to learn that its session is over, whatever is said to the second.
TEST(TwoBenches, ARefusalDoesNotTakeThePlaceOfTheEndOfASession) {
  TwoBenches both{0};
  hal::sim::CanBus ear{both.rig.wire};
  both.rig.hardware.imu.rate = {500, 0, 0};
  std::vector<SessionReply> of_the_first;
  for (int i = 0; i < 300; ++i) {
    both.second.say(protocol::BenchSession{.action = SessionAction::open, .session = second_session});
    both.rig.tick();
    while (const auto frame = ear.receive()) {
      const auto decoded = protocol::decode_from_avionics(bus_frame(*frame));
      const auto* reply = decoded.message ? std::get_if<SessionReply>(&*decoded.message) : nullptr;
      if (reply != nullptr && reply->session == first_session) {
        of_the_first.push_back(*reply);
      }
    }
  }
  ASSERT_GE(of_the_first.size(), 3U) << "at once, and ten times a second";
  EXPECT_EQ(of_the_first.back().state, protocol::SessionState::closed);
  EXPECT_EQ(of_the_first.back().reason, SessionReason::not_at_rest);
}

INSTANTIATE_TEST_SUITE_P(Milliseconds, AtEveryRate, testing::Values(1, 3, 5, 20, 50, 90));

// More frames than a tick has time for.

hal::CanFrame nobodys() { return {.id = 0x7FF}; }
hal::CanFrame begin(std::uint8_t counter) {
  return can_frame(encode(protocol::ArmRequest{.action = protocol::ArmAction::begin}, counter));
}

/// Frames that have arrived and have not been read.
int left_on(hal::sim::CanBus& board) {
  int left = 0;
  while (board.receive()) {
    left += 1;
  }
  return left;
}

TEST(BusFlood, ATickReads24FramesAndNotOneMoreWhateverTheyAre) {
  for (const int every : {1, 2, 1000}) {  // each is good, every other one, none
    hal::sim::CanWire wire;
    hal::sim::CanBus board{wire};
    hal::sim::CanBus node{wire};
    BusReceiver receiver;
    for (int i = 0; i < 60; ++i) {
      (void)node.send((i + 1) % every == 0 ? begin(static_cast<std::uint8_t>(i % 16)) : nobodys());
    }
    int messages = 0;
    receiver.begin_tick();
    for (int again = 0; again < 100; ++again) {
      messages += receiver.next({}, board, std::nullopt) ? 1 : 0;
    }
    EXPECT_EQ(messages, 24 / every);
    EXPECT_EQ(receiver.rejections().count[static_cast<std::size_t>(protocol::Rejection::unknown_id)], 24 - messages);
    EXPECT_EQ(left_on(board), 60 - 24);
  }
}

}  // namespace

}  // namespace fantail::avionics
