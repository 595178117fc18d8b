// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "avionics/can_frame.hpp"
#include "core/flight_plan_fields.hpp"
#include "link/plan_sender.hpp"
#include "replies/sentence.hpp"
#include "sil/bench_at_world.hpp"

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
    EXPECT_EQ(std::string{error.what()},
              "the avionics has written the plan but does not use it yet: it comes into force when the phase is Safe "
              "and no bench session "
              "or self-test goes on");
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
