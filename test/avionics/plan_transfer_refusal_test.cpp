// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "avionics/plan_transfer.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/bus_messages.hpp"
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

}  // namespace
}  // namespace fantail::avionics
