// SPDX-License-Identifier: MIT
// One frame of somebody else with an identifier of the avionics: reports carry no CRC and no name of their sender.
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "avionics/can_frame.hpp"
#include "link/arm_steps.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

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
    EXPECT_STREQ(
        error.what(),
        "the answers about the self-test contradict each other: another node on this bus sends them too (frame 0x121)");
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

}  // namespace
}  // namespace fantail::sil
