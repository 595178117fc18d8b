// SPDX-License-Identifier: MIT
#include "avionics/plan_transfer.hpp"

#include "protocol/bus_messages.hpp"
#include "test.hpp"
#include "transfer_rig.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;
using protocol::PlanBlockFault;
using protocol::TransferFault;
using protocol::TransferState;

TEST_F(PlanTransferTest, EveryFrameIsAnsweredWithTheIndexOfTheNext) {
  rig.begin(eight);
  const auto first = rig.step();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->state, TransferState::receiving);
  EXPECT_EQ(first->next_index, 0);
  const std::size_t frames = (eight.size() + 6) / 7;
  for (std::size_t index = 0; index + 1 < frames; ++index) {
    rig.data(eight, index);
    const auto reply = rig.step();
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(reply->state, TransferState::receiving);
    EXPECT_EQ(reply->fault, TransferFault::none);
    EXPECT_EQ(reply->next_index, index + 1);
    EXPECT_FALSE(rig.step().has_value()) << "one frame, one reply";
  }
  rig.data(eight, frames - 1);
  const auto last = rig.step();
  ASSERT_TRUE(last.has_value());
  EXPECT_EQ(last->state, TransferState::writing);
  EXPECT_EQ(last->next_index, frames);
}

TEST_F(PlanTransferTest, APlanIsHandedOutOnceAndOnlyWhenItHasBeenReadBack) {
  rig.send(eight);
  EXPECT_TRUE(rig.service.transfer().writing());
  while (rig.state() == TransferState::writing) {
    ASSERT_FALSE(rig.taken.has_value());
    ASSERT_LT(rig.world.time, 3s);
    rig.step();
  }
  EXPECT_EQ(rig.state(), TransferState::stored);
  EXPECT_FALSE(rig.service.transfer().writing());
  ASSERT_TRUE(rig.taken.has_value());
  EXPECT_EQ(number_of(*rig.taken), 8);
  EXPECT_EQ(rig.service.transfer().block_crc(), protocol::plan_block_crc(eight));
  EXPECT_EQ(rig.stored_number(), 8);
  rig.run(100);
  EXPECT_FALSE(rig.service.transfer().take_plan().has_value());
}

TEST_F(PlanTransferTest, AFrameThatComesAgainIsAnsweredAgainAndChangesNothing) {
  rig.begin(eight);
  rig.data(eight, 0);
  rig.data(eight, 1);
  rig.step();
  Bytes other = eight;
  other[0] ^= std::byte{1};
  rig.data(other, 0);
  const auto reply = rig.step();
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->state, TransferState::receiving);
  EXPECT_EQ(reply->fault, TransferFault::none);
  EXPECT_EQ(reply->next_index, 2);
  for (std::size_t index = 2; 7 * index < eight.size(); ++index) {
    rig.data(eight, index);
  }
  rig.run(100);
  EXPECT_EQ(rig.state(), TransferState::stored);
}

TEST_F(PlanTransferTest, AFrameThatJumpsIsNamedAndTheTransferGoesOnWhereItStood) {
  rig.begin(eight);
  rig.data(eight, 0);
  rig.data(eight, 2);
  const auto reply = rig.step();
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->state, TransferState::receiving);
  EXPECT_EQ(reply->fault, TransferFault::out_of_order);
  EXPECT_EQ(reply->next_index, 1);
  rig.data(eight, 1);
  EXPECT_EQ(rig.step()->fault, TransferFault::none);
  EXPECT_EQ(rig.reply->next_index, 2);
}

TEST_F(PlanTransferTest, AFramePastTheEndIsNotTakenIn) {
  const std::size_t frames = (eight.size() + 6) / 7;
  rig.begin(eight);
  for (std::size_t index = 0; index < frames; ++index) {
    rig.data(eight, index);
  }
  rig.data(seven, frames);
  rig.data(seven, frames + 1);
  EXPECT_EQ(rig.service.transfer().reply()->fault, TransferFault::out_of_order);
  rig.data(seven, frames);
  EXPECT_EQ(rig.step()->state, TransferState::writing);
  EXPECT_EQ(rig.reply->next_index, frames);
  rig.run(100);
  EXPECT_EQ(rig.stored_number(), 8);
}

TEST_F(PlanTransferTest, TheLastFrameIsAnsweredAgainWithWhatHasBecomeOfItAll) {
  const std::size_t last = (eight.size() - 1) / 7;
  rig.send(eight);
  rig.data(eight, last);
  EXPECT_EQ(rig.step()->state, TransferState::writing);
  rig.run(100);
  rig.data(eight, last);
  const auto reply = rig.step();
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->state, TransferState::stored);
}

TEST_F(PlanTransferTest, ABeginningThatComesAgainBeginsAgain) {
  rig.begin(seven);
  rig.data(seven, 0);
  rig.step();
  rig.begin(eight);
  EXPECT_EQ(rig.step()->next_index, 0);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, ABeginningDuringAWriteIsAnsweredAndTheWriteGoesOn) {
  rig.send(eight);
  rig.begin(seven);
  EXPECT_EQ(rig.step()->state, TransferState::writing);
  rig.run(100);
  EXPECT_EQ(rig.state(), TransferState::stored);
  EXPECT_EQ(rig.stored_number(), 8);
}

TEST_F(PlanTransferTest, DataWithoutABeginningIsRefused) {
  rig.data(eight, 0);
  rig.step();
  expect_refused(TransferFault::out_of_order);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, ABlockOfNoSizeOrBeyondTheLargestIsRefused) {
  for (const auto size : std::array<std::uint16_t, 3>{0, 1025, 65'535}) {
    rig.begin(size, 0);
    rig.step();
    expect_refused(TransferFault::wrong_size);
  }
  rig.begin(1024, 0);
  EXPECT_EQ(rig.step()->state, TransferState::receiving);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, TheLargestBlockIsTakenInAndThenJudged) {
  const Bytes large(1024, std::byte{0x42});
  rig.send(large);
  expect_refused(TransferFault::bad_block);
  EXPECT_EQ(rig.reply->next_index, 147);
  EXPECT_EQ(rig.reply->block_fault, PlanBlockFault::no_plan_block);
}

TEST_F(PlanTransferTest, ASecondWithoutProgressEndsATransfer) {
  rig.begin(eight);
  rig.data(eight, 0);
  rig.run(1000);
  EXPECT_EQ(rig.state(), TransferState::receiving);
  rig.step();
  expect_refused(TransferFault::timed_out);
  rig.data(eight, 1);
  rig.step();
  expect_refused(TransferFault::timed_out);
  expect_next_one_is_stored();
}

TEST_F(PlanTransferTest, FramesThatOnlyRepeatThemselvesDoNotKeepATransferAlive) {
  rig.begin(eight);
  rig.data(eight, 0);
  for (int i = 0; i <= 1000; ++i) {
    rig.data(eight, i % 2 == 0 ? 0 : 9);
    rig.step();
  }
  expect_refused(TransferFault::timed_out);
}

}  // namespace
}  // namespace fantail::avionics
