// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "link/arm_steps.hpp"
#include "replies/sentence.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using core::Phase;

// The bench and the hand at the switch.
Phase arm(BenchAtWorld& place, bool start = false) {
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  EXPECT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  place.world->set_arm_switch(true);
  place.wait(100 * millisecond);
  const protocol::ArmReply reply = steps.ask_for_nonce();
  EXPECT_TRUE(reply.nonce) << replies::sentence(reply.refusal);
  EXPECT_TRUE(steps.confirm(reply.nonce.value_or(0)));
  if (start) {
    EXPECT_TRUE(steps.start_control(reply.nonce.value_or(0)));
  }
  return place.record.phase;
}

TEST(BenchArm, ArmsARocketThatThenDetectsItsLaunch) {
  BenchAtWorld place{"tasha3_launch2"};
  ASSERT_EQ(arm(place), Phase::armed);
  place.wait(30 * second);
  EXPECT_EQ(place.record.phase, Phase::armed) << "it waits as long as it must";
  place.world->ignite();
  place.wait(second);
  EXPECT_EQ(place.record.phase, Phase::controlling);
  place.wait(40 * second);
  EXPECT_EQ(place.record.reason, core::PhaseReason::apogee);
}

// As the board does: test_hal_stm32f4 holds the two switches against each other.
TEST(BenchArm, ARocketStaysArmedWhileItsSwitchBouncesForLessThanFiftyMilliseconds) {
  BenchAtWorld place{"bench_healthy"};
  ASSERT_EQ(arm(place), Phase::armed);
  for (const int open_ms : {1, 2, 3, 30, 49}) {
    for (int bounce = 0; bounce < 20; ++bounce) {
      place.world->set_arm_switch(false);
      place.wait(open_ms * millisecond);
      place.world->set_arm_switch(true);
      place.wait(millisecond);
      ASSERT_EQ(place.record.phase, Phase::armed) << "open for " << open_ms << " ms";
    }
  }
  place.world->set_arm_switch(false);
  place.wait(51 * millisecond);
  EXPECT_EQ(place.record.phase, Phase::safe);
  EXPECT_EQ(place.record.reason, core::PhaseReason::disarmed_by_switch);
}

// Meets ARM-6 on a board whose switch takes 50 ms to be known.
TEST(BenchArm, ASwitchThatWasClosedBeforePowerUpHasToBeOpenedFirst) {
  BenchAtWorld place{"bench_healthy"};
  place.world->set_arm_switch(true);
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  ASSERT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  EXPECT_EQ(steps.ask_for_nonce().refusal, protocol::ArmRefusal::switch_not_cycled);
  place.world->set_arm_switch(false);
  place.wait(100 * millisecond);
  place.world->set_arm_switch(true);
  place.wait(100 * millisecond);
  EXPECT_TRUE(steps.ask_for_nonce().nonce);
}

TEST(BenchArm, StartsControlInTheTunnel) {
  BenchAtWorld place{"tunnel_steps"};
  EXPECT_EQ(arm(place, true), Phase::controlling);
}

TEST(BenchArm, IsToldWhichCanardFailedTheSelfTest) {
  BenchAtWorld place{"bench_canard3_reversed"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  const protocol::ArmReply reply = steps.run_self_test([](const auto&) {});
  EXPECT_EQ(reply.self_test, protocol::SelfTestState::failed);
  EXPECT_EQ(reply.failure, protocol::SelfTestFailure::canard_did_not_follow);
  EXPECT_TRUE(says(replies::sentence(reply.failure, reply.canard), "canard 3"));
}

// It fails in the very tick in which it begins, so nobody ever hears that it runs; the second time nothing changes.
TEST(BenchArm, IsToldThatTheGyroIsGoneAndToldAgain) {
  sim::Scenario scenario = input::load_scenario("bench_healthy", {});
  scenario.faults.push_back({.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = -1e6, .until_s = 1e6});
  BenchAtWorld place{scenario};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  for (int time = 0; time < 2; ++time) {
    link::ArmSteps steps{place, link};
    const protocol::ArmReply reply = steps.run_self_test([](const auto&) {});
    EXPECT_EQ(reply.failure, protocol::SelfTestFailure::gyro_failed);
    place.wait(second);
  }
}

TEST(BenchArm, ARefusedSelfTestIsSaidSoAndTheEarlierPassStillArms) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  ASSERT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  for (int time = 0; time < 2; ++time) {  // the second time the reason is not new
    link::Session session{place, link, 5};
    try {
      (void)link::ArmSteps{place, link}.run_self_test([](const auto&) {});
      ADD_FAILURE() << "it ran inside a session";
    } catch (const link::SelfTestRefused& refusal) {
      EXPECT_EQ(refusal.what(), replies::sentence(protocol::ArmRefusal::session_open));
    }
  }
  place.world->set_arm_switch(true);
  place.wait(300 * millisecond);
  EXPECT_TRUE(steps.ask_for_nonce().nonce);
}

/// A PC that hears the rocket and whose own frames are lost.
class MutePc final : public link::Place, private hal::CanBus {
 public:
  explicit MutePc(BenchAtWorld& place) : place_{place} {}
  [[nodiscard]] hal::CanBus& bus() override { return *this; }
  [[nodiscard]] hal::Microseconds now() const override { return place_.now(); }
  void wait(hal::Microseconds at_most) override { place_.wait(at_most); }

 private:
  [[nodiscard]] bool send(const hal::CanFrame& /*frame*/) override { return true; }
  std::optional<hal::CanFrame> receive() override { return place_.bus().receive(); }
  [[nodiscard]] hal::CanState state() const override { return place_.bus().state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return place_.bus().counters(); }

  BenchAtWorld& place_;
};

TEST(BenchArm, AnEarlierPassIsNotTakenForTheAnswerToARequestThatWasLost) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  ASSERT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  MutePc mute{place};
  link::ArmSteps later{mute, link};
  EXPECT_THROW((void)later.run_self_test([](const auto&) {}), link::LinkError);
}

TEST(BenchArm, WithoutTheSwitchIsRefusedWithThatReason) {
  BenchAtWorld place{"tasha3_launch2"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  (void)steps.run_self_test([](const auto&) {});
  const protocol::ArmReply reply = steps.ask_for_nonce();
  EXPECT_FALSE(reply.nonce);
  EXPECT_EQ(reply.refusal, protocol::ArmRefusal::switch_open);
}

// A flight begins with the world's own crew: nothing else arms a rocket there either.
TEST(PadCrew, ARocketWithABrokenCanardIsNotArmedAndTheReasonIsKept) {
  const sim::Scenario scenario = input::load_scenario("bench_canard3_reversed", {});
  sim::World world{scenario};
  while (!world.over()) {
    EXPECT_EQ(world.tick().phase, Phase::safe);
    world.advance();
  }
  ASSERT_TRUE(world.refusal_to_arm());
  EXPECT_EQ(world.refusal_to_arm()->failure, protocol::SelfTestFailure::canard_did_not_follow);
  EXPECT_EQ(world.refusal_to_arm()->canard, 2U);
}

}  // namespace
}  // namespace fantail::sil
