// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "figures.hpp"
#include "link/arm_steps.hpp"
#include "protocol/bus_codec.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

// One frame of somebody else with an identifier of the avionics: reports carry no CRC and no name of their sender.

using protocol::ArmReply;
using protocol::SelfTestState;

class Stranger : public testing::Test {
 protected:
  Stranger() {
    link::await_avionics(place, link);
    place.wait(3 * second);
  }
  template <typename Message>
  void say(const Message& message) {
    (void)stranger.send(avionics::can_frame(encode(message)));
  }

  BenchAtWorld place{"bench_healthy"};
  hal::sim::CanBus stranger{place.wire};
  link::AvionicsLink link{place.bus()};
  link::ArmSteps steps{place, link};
};

const std::array strange_replies{
    ArmReply{.self_test = SelfTestState::running}, ArmReply{.self_test = SelfTestState::passed},
    ArmReply{.self_test = SelfTestState::failed, .failure = protocol::SelfTestFailure::moved},
    ArmReply{.self_test = SelfTestState::failed, .failure = protocol::SelfTestFailure::encoder_silent, .canard = 3},
    ArmReply{.refusal = protocol::ArmRefusal::session_open}};

// Before the test begins, while the rocket is watched for its rest, and while a canard moves.
TEST_F(Stranger, OneArmReplyDuringTheSelfTestNeitherNamesACanardNorEndsIt) {
  for (const ArmReply& reply : strange_replies) {
    for (const int after_ms : {5, 50, 700, 2'000, 3'200, 4'400, 5'600, 6'700}) {
      place.after_tick = [&, ticks = 0]() mutable {
        if (++ticks == after_ms) {
          say(reply);
        }
      };
      link::CanardUnderTest under_test;
      std::vector<std::size_t> told;
      ArmReply answer;
      try {
        answer = steps.run_self_test([&](const ArmReply& now) {
          if (const auto canard = under_test.news(now)) {
            told.push_back(*canard);
          }
        });
      } catch (const link::SelfTestRefused& refusal) {
        ADD_FAILURE() << refusal.what();
      }
      place.after_tick = nullptr;
      EXPECT_EQ(answer.self_test, SelfTestState::passed) << after_ms << " ms";
      EXPECT_EQ(told, (std::vector<std::size_t>{0, 1, 2, 3})) << after_ms << " ms";
      EXPECT_FALSE(link.reported<protocol::StatusReport>("state").self_test_running) << "said to be over while it ran";
    }
  }
}

TEST_F(Stranger, ArmRepliesThatContradictTheAvionicsForLongAreSaidToBeSomebodyElses) {
  place.after_tick = [&, ticks = 0]() mutable {
    if (++ticks % 50 == 0) {
      say(strange_replies[3]);
    }
  };
  try {
    (void)steps.run_self_test([](const auto&) {});
    ADD_FAILURE() << "an answer was believed";
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "0x121")) << error.what();
  }
}

TEST_F(Stranger, AStatusThatSaysArmedDoesNotMakeTheRocketArmed) {
  place.after_tick = [&, ticks = 0]() mutable {
    if (++ticks % 25 == 0) {
      say(protocol::StatusReport{.phase = core::Phase::armed, .arm_switch_closed = true});
    }
  };
  EXPECT_FALSE(steps.confirm(12345));
  EXPECT_EQ(place.record.phase, core::Phase::safe);
}

// Nobody but a stranger speaks, and of three kinds alone.
TEST(StrangerAlone, IsNotTakenForAnAvionicsHoweverItLooks) {
  BenchAtWorld place{"bench_healthy"};
  place.switch_off();
  hal::sim::CanBus stranger{place.wire};
  std::uint32_t uptime_ms = 0;
  place.after_tick = [&] {
    uptime_ms += 1;
    if (uptime_ms % 100 == 0) {
      (void)stranger.send(avionics::can_frame(encode(protocol::HeartbeatReport{.uptime_ms = uptime_ms})));
      (void)stranger.send(avionics::can_frame(encode(protocol::LimitReport{})));
      (void)stranger.send(avionics::can_frame(encode(ArmReply{.self_test = SelfTestState::running, .canard = 1})));
    }
  };
  link::AvionicsLink link{place.bus()};
  EXPECT_THROW(link::await_avionics(place, link), link::LinkError);
  EXPECT_THROW((void)link.reported<protocol::StatusReport>("state"), link::LinkError);
  link::ArmSteps steps{place, link};
  EXPECT_THROW((void)steps.run_self_test([](const auto&) {}), link::LinkError);
  EXPECT_THROW((void)steps.confirm(1), link::LinkError);
}

// Two bench programs at one rocket, as far as a program goes without its process.

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
  EXPECT_TRUE(says(refusal_of_a_session(beside, link, 6), "another bench"));
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
  EXPECT_TRUE(says(refusal_of_a_session(beside, link, 6), "another bench"));
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
