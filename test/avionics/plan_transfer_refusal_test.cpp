// SPDX-License-Identifier: MIT
#include "avionics/plan_transfer.hpp"
#include "core/flight_plan_fields.hpp"
#include "properties.hpp"
#include "protocol/bus_messages.hpp"
#include "random_stream.hpp"
#include "transfer_rig.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;
using protocol::PlanBlockFault;
using protocol::TransferFault;
using protocol::TransferState;

TEST_F(PlanTransferTest, ABlockWithAnotherChecksumThanWasAnnouncedIsRefused) {
  rig.begin(static_cast<std::uint16_t>(eight.size()), protocol::plan_block_crc(seven));
  for (std::size_t index = 0; 7 * index < eight.size(); ++index) {
    rig.data(eight, index);
  }
  rig.step();
  expect_refused(TransferFault::bad_block);
  EXPECT_EQ(rig.reply->block_fault, PlanBlockFault::wrong_checksum);
  EXPECT_FALSE(rig.reply->field.has_value());
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, EveryBitThatFlipsOnTheWayIsNoticed) {
  for (std::size_t bit = 0; bit < 8 * eight.size(); ++bit) {
    Bytes flipped = eight;
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    rig.begin(eight);
    for (std::size_t index = 0; 7 * index < eight.size(); ++index) {
      rig.data(flipped, index);
    }
    rig.step();
    ASSERT_EQ(rig.fault(), TransferFault::bad_block) << bit;
  }
  expect_refused(TransferFault::bad_block);
}

TEST_F(PlanTransferTest, APlanThatMustNotFlyIsRefusedByTheNameOfItsField) {
  const auto fields = core::flight_plan_fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].is_list() || fields[i].kind != core::FieldKind::number || fields[i].is_time()) {
      continue;
    }
    core::FlightPlan bad = numbered_plan(8);
    fields[i].set_bits(bad, 0, 0x7FC00000U);  // not a number
    rig.send(block_of(bad));
    expect_refused(TransferFault::bad_block);
    EXPECT_EQ(rig.reply->block_fault, PlanBlockFault::refused) << fields[i].key;
    EXPECT_EQ(rig.reply->field, i) << fields[i].key;
  }
  expect_next_one_is_stored();
  EXPECT_FALSE(rig.reply->field.has_value());
  EXPECT_FALSE(rig.reply->block_fault.has_value());
}

TEST_F(PlanTransferTest, ABeginningThatIsRefusedLeavesTheTransferThatIsUnderWay) {
  rig.begin(eight);
  rig.step();
  for (std::size_t index = 0; 7 * index < eight.size(); ++index) {
    for (const std::size_t size : {std::size_t{0}, protocol::largest_plan_block + 1}) {
      rig.begin(static_cast<std::uint16_t>(size), 0);
      rig.step();
      ASSERT_EQ(rig.state(), TransferState::refused);
      ASSERT_EQ(rig.fault(), TransferFault::wrong_size);
    }
    rig.data(eight, index);
    ASSERT_TRUE(rig.step());
    ASSERT_NE(rig.state(), TransferState::refused) << index;
  }
  rig.run(100);
  EXPECT_EQ(rig.state(), TransferState::stored);
  EXPECT_EQ(rig.stored_number(), 8);
}

TEST_F(PlanTransferTest, NothingBeginsOutsideSafe) {
  rig.safe = false;
  rig.begin(eight);
  rig.step();
  expect_refused(TransferFault::not_safe);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, ATransferEndsWhenThePhaseIsNoLongerSafe) {
  for (const bool noticed_by_a_frame : {true, false}) {
    rig.safe = true;
    rig.begin(eight);
    rig.data(eight, 0);
    rig.step();
    rig.safe = false;
    if (noticed_by_a_frame) {
      rig.data(eight, 1);
    }
    rig.step();
    expect_refused(TransferFault::not_safe);
  }
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, AWriteThatHasNotBegunIsGivenUpWhenThePhaseIsNoLongerSafe) {
  rig.flash.set_stays_busy(true);
  rig.send(eight);
  EXPECT_EQ(rig.state(), TransferState::writing);
  rig.safe = false;
  rig.step();
  expect_refused(TransferFault::not_safe);
  rig.flash.set_stays_busy(false);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, AWriteThatHasBegunGoesOnAndItsPlanIsKeptBackUntilThePhaseIsSafeAgain) {
  rig.send(eight);
  rig.step();
  rig.safe = false;
  rig.run(100);
  EXPECT_EQ(rig.stored_number(), 8);
  EXPECT_TRUE(rig.service.transfer().writing());
  EXPECT_FALSE(rig.taken.has_value());
  rig.safe = true;
  rig.step();
  EXPECT_EQ(rig.state(), TransferState::stored);
  EXPECT_TRUE(rig.taken.has_value());
}

TEST_F(PlanTransferTest, APlanThatNobodyHasTakenYetIsNotLostToTheNextTransfer) {
  rig.send(eight);
  while (rig.service.transfer().writing()) {
    rig.service.update(rig.world.time, true);
    rig.world.time += tick;
  }
  rig.begin(seven);
  rig.step();
  EXPECT_EQ(rig.state(), TransferState::stored);
  ASSERT_TRUE(rig.taken.has_value());
  EXPECT_EQ(number_of(*rig.taken), 8);
  rig.begin(seven);
  EXPECT_EQ(rig.step()->state, TransferState::receiving);
}

TEST_F(PlanTransferTest, AFlashThatFailsOrKeepsNothingIsNamedAndTheOldPlanStays) {
  rig.flash.set_answers(false);
  rig.send(eight);
  rig.run(100);
  expect_refused(TransferFault::flash_failed);
  rig.flash.set_answers(true);
  rig.flash.set_stays_busy(true);
  rig.send(eight);
  rig.run(2100);
  expect_refused(TransferFault::flash_failed);
  rig.flash.set_stays_busy(false);
  rig.flash.stick(4096 + 300, std::byte{0xFF}, ~eight[44]);
  rig.send(eight);
  rig.run(100);
  expect_refused(TransferFault::read_back_differs);
}

using protocol::TransferState;

// A bench that waits for the reply to each frame and says it again after 20 ms, on a bus that loses, doubles and
// delays.
bool bench_gets_through(TransferRig& rig, const Bytes& block, core::RandomStream& random) {
  constexpr int begin_frame = -1;
  std::vector<int> late;  // frames that will come once more, later
  const auto deliver = [&](int frame) {
    if (frame == begin_frame) {
      rig.begin(block);
    } else {
      rig.data(block, static_cast<std::size_t>(frame));
    }
  };
  int next = begin_frame;
  int waited = 0;
  for (int ticks = 0; ticks < 20'000; ++ticks) {
    if (waited % 20 == 0) {
      if (!random.chance(0.2)) {
        deliver(next);
      }
      if (random.chance(0.1)) {
        deliver(next);
      }
      if (next != begin_frame && random.chance(0.1)) {  // a beginning that came late would rightly begin again
        late.push_back(next);
      }
    }
    if (!late.empty() && random.chance(0.05)) {
      deliver(late.back());
      late.pop_back();
    }
    waited += 1;
    const auto reply = rig.step();
    if (!reply || random.chance(0.2)) {
      continue;
    }
    if (reply->state == TransferState::stored || reply->state == TransferState::refused) {
      return reply->state == TransferState::stored;
    }
    if (reply->state == TransferState::receiving && (next == begin_frame || reply->next_index > next)) {
      next = reply->next_index;
      waited = 0;
    }
  }
  return false;
}

RC_GTEST_PROP(PlanTransfer, ABenchThatRepeatsItselfGetsThroughABusThatLosesDoublesAndDelays, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  TransferRig rig;
  const int number = random.whole(1, 100);
  RC_ASSERT(bench_gets_through(rig, block_of(numbered_plan(number)), random));
  RC_ASSERT(rig.taken && number_of(*rig.taken) == number);
  RC_ASSERT(rig.stored_number() == number);
}

// Random messages, mixed with pieces of a real transfer, through every state, with phases and power that come and go.
RC_GTEST_PROP(PlanTransfer, WhateverArrivesThePlanInFlashIsOneThatWasSentAsAWhole, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  Bytes cells = flash_holding(7);
  int in_force = 7;
  for (int life = 0; life < 3; ++life) {
    TransferRig rig{cells};
    RC_ASSERT(rig.found.plan && number_of(*rig.found.plan) == in_force);
    const int number = random.whole(1, 100);
    const Bytes block = block_of(numbered_plan(number));
    std::size_t next = 0;
    for (int message = 0; message < 1500; ++message) {
      if (random.chance(0.002)) {
        rig.begin(static_cast<std::uint16_t>(random.whole(0, 0xFFFF)), static_cast<std::uint32_t>(random.whole(0, 9)));
      } else if (random.chance(0.005)) {
        rig.begin(block);
        next = 0;
      } else if (random.chance(0.002)) {
        const protocol::PlanData noise{.index = static_cast<std::uint8_t>(random.whole(0, 255)),
                                       .bytes = {static_cast<std::byte>(random.whole(0, 255))}};
        rig.service.transfer().receive(rig.world.time, noise, rig.safe);
      } else {
        rig.data(block, next);
        next += next < 200 ? 1 : 0;
      }
      rig.safe = rig.safe ? !random.chance(0.003) : random.chance(0.3);
      rig.taken.reset();
      rig.step();
      if (rig.taken) {
        RC_ASSERT(number_of(*rig.taken) == number);
        in_force = number;
      }
    }
    rig.flash.cut_power(seed);
    cells = rig.cells();
    const int after = rig.stored_number();
    RC_ASSERT(after == in_force || after == number);
    in_force = after;
  }
}

}  // namespace

}  // namespace fantail::avionics
