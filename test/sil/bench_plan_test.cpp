// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "link/arm_steps.hpp"
#include "link/plan_transfer.hpp"
#include "replies/sentence.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using protocol::TransferState;

std::vector<std::byte> block_of(const core::FlightPlan& plan) {
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(plan, block);
  return {block.begin(), block.begin() + static_cast<std::ptrdiff_t>(size)};
}

core::FlightPlan plan_with_limit(float limit_deg) {
  core::FlightPlan plan = core::default_plan();
  plan.controller.canard_limit = core::Angle::from_degrees(limit_deg);
  return plan;
}

protocol::PlanReply send_without_waiting(BenchAtWorld& place, std::span<const std::byte> block) {
  link::AvionicsLink link{place.bus()};
  return link::send_plan(place, link, block, [](std::size_t) {});
}

protocol::PlanReply send(BenchAtWorld& place, std::span<const std::byte> block) {
  place.wait(3 * second);  // at rest long enough
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  return link::send_plan(place, link, block, [](std::size_t) {});
}

float limit_in_force_deg(BenchAtWorld& place) {
  link::AvionicsLink link{place.bus()};
  for (int i = 0; i < 600; ++i) {  // it is reported once a second
    place.wait(2 * millisecond);
    link.listen(place.now());
  }
  return link.newest<protocol::LimitReport>()->message.limit[0].degrees();
}

TEST(BenchPlan, ANewPlanIsInForceAtOnceAndAfterTheNextPowerUp) {
  BenchAtWorld place{"bench_healthy"};
  ASSERT_EQ(send(place, block_of(plan_with_limit(4.0F))).state, TransferState::stored);
  EXPECT_NEAR(limit_in_force_deg(place), 4.0F, 0.001F);
  place.power_cycle();
  EXPECT_NEAR(limit_in_force_deg(place), 4.0F, 0.001F);
}

TEST(BenchPlan, ABrokenBlockLeavesTheOldPlanInForce) {
  BenchAtWorld place{"bench_healthy"};
  std::vector<std::byte> block = block_of(plan_with_limit(4.0F));
  block[100] ^= std::byte{1};
  const protocol::PlanReply reply = send(place, block);
  EXPECT_EQ(reply.state, TransferState::refused);
  EXPECT_EQ(reply.fault, protocol::TransferFault::bad_block);
  EXPECT_NEAR(limit_in_force_deg(place), 9.0F, 0.001F);
}

TEST(BenchPlan, IsRefusedToARocketThatHasNotYetStoodStill) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  const protocol::PlanReply reply = link::send_plan(place, link, block_of(plan_with_limit(4.0F)), [](std::size_t) {});
  EXPECT_EQ(reply.fault, protocol::TransferFault::not_safe);
  EXPECT_NEAR(limit_in_force_deg(place), 9.0F, 0.001F);
}

TEST(BenchPlan, ARefusedFieldIsNamed) {
  BenchAtWorld place{"bench_healthy"};
  const protocol::PlanReply reply = send(place, block_of(plan_with_limit(25.0F)));
  EXPECT_EQ(reply.state, TransferState::refused);
  EXPECT_EQ(replies::sentence(reply), "controller.canard_limit_deg is out of range");
  EXPECT_NEAR(limit_in_force_deg(place), 9.0F, 0.001F);
}

TEST(BenchPlan, IsRefusedWhileABenchSessionIsOpen) {
  BenchAtWorld place{"bench_healthy"};
  place.wait(4 * second);
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::Session session{place, link, 3};  // whose canards must not jump to other trims
  link.listen(place.now());
  bool refused = false;
  std::uint8_t counter = 0;
  for (int i = 0; i < 50 && !refused; ++i) {
    const auto frame = encode(protocol::PlanBegin{.size = 500, .block_crc = 1}, counter++ & 0xFU);
    (void)place.bus().send(avionics::can_frame(frame));
    session.wait(20 * millisecond);
    const auto& reply = link.newest<protocol::PlanReply>();
    refused = reply && reply->message.fault == protocol::TransferFault::not_safe;
  }
  EXPECT_TRUE(refused);
}

// A bench that ended while its plan was being written, and a session that keeps that plan back for a while.
void leave_a_plan_in_writing(BenchAtWorld& place, std::span<const std::byte> block) {
  const auto say = [&place](const protocol::BusFrame& frame) {
    (void)place.bus().send(avionics::can_frame(frame));
    place.wait(millisecond);
  };
  say(encode(protocol::PlanBegin{.size = static_cast<std::uint16_t>(block.size()),
                                 .block_crc = protocol::plan_block_crc(block)},
             0));
  for (std::size_t at = 0; at < block.size(); at += 7) {
    protocol::PlanData data{.index = static_cast<std::uint8_t>(at / 7)};
    std::ranges::copy(block.subspan(at, std::min<std::size_t>(7, block.size() - at)), data.bytes.begin());
    say(encode(data));
  }
  say(encode(protocol::BenchSession{.action = protocol::SessionAction::open, .session = 3}, 0));
}

TEST(BenchPlan, APlanOfAnotherBenchThatIsStoredMeanwhileIsNotTakenForItsOwn) {
  BenchAtWorld place{"bench_healthy"};
  place.wait(4 * second);
  leave_a_plan_in_writing(place, block_of(plan_with_limit(4.0F)));
  // The other's plan comes into force, and a rocket with a new plan has not yet been seen at rest.
  const protocol::PlanReply reply = send_without_waiting(place, block_of(plan_with_limit(6.0F)));
  EXPECT_EQ(reply.state, TransferState::refused);
  EXPECT_EQ(reply.fault, protocol::TransferFault::not_safe);
  EXPECT_NEAR(limit_in_force_deg(place), 4.0F, 0.001F);
}

TEST(BenchPlan, WhileTheAvionicsKeepsAWrittenPlanBackThatIsSaidAndNothingPromised) {
  BenchAtWorld place{"bench_healthy"};
  place.wait(4 * second);
  link::AvionicsLink link{place.bus()};
  hal::sim::CanBus other_bench{place.wire};
  std::uint8_t counter = 0;
  int ticks = 0;
  place.after_tick = [&] {
    const auto& reply = link.newest<protocol::PlanReply>();
    if (reply && reply->message.state == TransferState::writing && ticks++ % 20 == 0) {
      const protocol::BenchSession open{.action = protocol::SessionAction::open, .session = 3};
      (void)other_bench.send(avionics::can_frame(encode(open, counter++ & 0xFU)));
    }
  };
  try {
    (void)link::send_plan(place, link, block_of(plan_with_limit(4.0F)), [](std::size_t) {});
    FAIL() << "the session came too late";
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "written") && says(error.what(), "session")) << error.what();
  }
  place.after_tick = nullptr;
  EXPECT_NEAR(limit_in_force_deg(place), 4.0F, 0.001F);
}

TEST(BenchPlan, FramesThatAreLostAreSentAgain) {
  BenchAtWorld place{"bench_healthy"};
  int ticks = 0;
  place.after_tick = [&] {
    ticks += 1;
    if (ticks % 7 == 0) {
      (void)place.board_bus.receive();
    }
    if (ticks % 11 == 0) {
      (void)place.pc_bus.receive();
    }
  };
  EXPECT_EQ(send(place, block_of(plan_with_limit(4.0F))).state, TransferState::stored);
}

link::PlanInForce read_back(BenchAtWorld& place) {
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  return link::read_plan_in_force(place, link);
}

TEST(BenchPlan, IsReadBackAsItIsInForce) {
  BenchAtWorld place{"bench_healthy"};
  const link::PlanInForce built_in = read_back(place);
  EXPECT_EQ(built_in.source, protocol::PlanSource::built_in);
  EXPECT_EQ(block_of(built_in.plan), block_of(place.scenario.plan));
  const std::vector<std::byte> block = block_of(plan_with_limit(4.0F));
  ASSERT_EQ(send(place, block).state, TransferState::stored);
  place.wait(second);
  const link::PlanInForce stored = read_back(place);
  EXPECT_EQ(stored.source, protocol::PlanSource::stored);
  EXPECT_EQ(stored.block_crc, protocol::plan_block_crc(block));
  EXPECT_EQ(block_of(stored.plan), block);
}

TEST(BenchPlan, WhatIsLostOnTheWayBackIsAskedForAgain) {
  BenchAtWorld place{"bench_healthy"};
  place.wait(4 * second);
  int ticks = 0;
  place.after_tick = [&] {
    ticks += 1;
    if (ticks % 7 == 0) {
      (void)place.board_bus.receive();
    }
    if (ticks % 11 == 0) {
      (void)place.pc_bus.receive();
    }
  };
  EXPECT_EQ(block_of(read_back(place).plan), block_of(place.scenario.plan));
}

/// The same bench behind a wire that changes data of the plan.
class Damage final : public link::Place, public hal::CanBus {
 public:
  explicit Damage(BenchAtWorld& place) : place_{place} {}
  [[nodiscard]] hal::CanBus& bus() override { return *this; }
  [[nodiscard]] hal::Microseconds now() const override { return place_.now(); }
  void wait(hal::Microseconds at_most) override { place_.wait(at_most); }
  bool send(const hal::CanFrame& frame) override { return place_.bus().send(frame); }
  std::optional<hal::CanFrame> receive() override {
    auto frame = place_.bus().receive();
    if (frame && frame->id == 0x180 && left_ > 0) {
      left_ -= 1;
      frame->data[3] ^= 0x10;
    }
    return frame;
  }
  [[nodiscard]] hal::CanState state() const override { return place_.pc_bus.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return place_.pc_bus.counters(); }
  void damage(int frames) { left_ = frames; }

 private:
  BenchAtWorld& place_;
  int left_ = 0;
};

TEST(BenchPlan, ADamagedPlanIsAskedForAgainAndNeverTakenForThePlan) {
  BenchAtWorld world{"bench_healthy"};
  Damage place{world};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  place.damage(3);
  EXPECT_EQ(block_of(link::read_plan_in_force(place, link).plan), block_of(world.scenario.plan));
  place.damage(1'000'000);
  try {
    (void)link::read_plan_in_force(place, link);
    FAIL() << "a damaged plan was taken";
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "complete")) << error.what();
  }
}

// A wrong plan in whole frames: the heartbeat is of another plan than the one that was read.
TEST(BenchPlan, APlanThatIsNotThatOfTheHeartbeatIsAnError) {
  BenchAtWorld place{"bench_healthy"};
  place.wait(4 * second);
  hal::sim::CanBus liar{place.wire};
  place.after_tick = [&] {
    (void)liar.send(avionics::can_frame(encode(protocol::HeartbeatReport{.uptime_ms = 1, .plan_crc = 0x12345678})));
  };
  EXPECT_THROW((void)read_back(place), link::LinkError);
}

TEST(BenchPlan, IsNotReadBackFromAnArmedRocket) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  link::ArmSteps steps{place, link};
  ASSERT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  place.world->set_arm_switch(true);
  place.wait(100 * millisecond);
  ASSERT_TRUE(steps.confirm(steps.ask_for_nonce().nonce.value_or(0)));
  try {
    (void)link::read_plan_in_force(place, link);
    FAIL() << "in phase " << core::name(place.record.phase);
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), replies::sentence(protocol::LogFault::not_safe))) << error.what();
  }
}

TEST(BenchPlan, ABusThatGoesAwayIsSaidSo) {
  BenchAtWorld place{"bench_healthy"};
  int ticks = 0;
  place.after_tick = [&] {
    if (++ticks == 3'500) {
      place.wire.set_state(hal::CanState::down);
    }
  };
  EXPECT_THROW((void)send(place, block_of(plan_with_limit(4.0F))), link::LinkError);
  place.wire.set_state(hal::CanState::error_active);
  EXPECT_NEAR(limit_in_force_deg(place), 9.0F, 0.001F);
}

}  // namespace
}  // namespace fantail::sil
