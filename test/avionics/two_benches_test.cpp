// SPDX-License-Identifier: MIT
// Two benches on one bus, in lock-step with the avionics: one session is one sender's.
#include <gtest/gtest.h>

#include "avionics/board_rig.hpp"

namespace fantail::avionics {
namespace {

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

}  // namespace
}  // namespace fantail::avionics
