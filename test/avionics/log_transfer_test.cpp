// SPDX-License-Identifier: MIT
#include "avionics/log_transfer.hpp"

#include "log_rig.hpp"
#include "protocol/crc32c.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using protocol::LogAction;
using protocol::LogFault;
using protocol::LogState;

/// The chunk whole, in order, each frame once.
void expect_chunk(LogRig& rig, std::uint32_t offset, std::uint16_t size, LogAction what = LogAction::read) {
  rig.data.clear();
  rig.ask(what, offset, size, 9);
  const auto reply = rig.reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->state, LogState::read);
  EXPECT_EQ(reply->fault, LogFault::none);
  EXPECT_EQ(reply->tag, 9);
  EXPECT_EQ(reply->extra, size);
  const std::span<const std::byte> whole =
      what == LogAction::plan ? std::span<const std::byte>{rig.plan_block} : rig.record;
  const auto wanted = whole.subspan(offset, size);
  EXPECT_EQ(reply->number, protocol::crc32c(wanted));
  ASSERT_EQ(rig.data.size(), (size + 6U) / 7U);
  for (std::size_t i = 0; i < 7 * rig.data.size(); ++i) {
    ASSERT_EQ(rig.data[i / 7].index, i / 7);
    ASSERT_EQ(rig.data[i / 7].bytes[i % 7], i < wanted.size() ? wanted[i] : std::byte{0}) << i;
  }
}

TEST(LogTransfer, SaysHowMuchThereIsAndHowMuchIsFree) {
  LogRig rig{9000};
  rig.power_up();
  rig.ask(LogAction::info);
  const auto reply = rig.reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->state, LogState::ready);
  EXPECT_EQ(reply->number, 3U * 4096U);  // whole sectors
  EXPECT_EQ(reply->extra, 9 * 4);
}

TEST(LogTransfer, AChunkOfAnySizeFromAnywhereArrivesWithItsCrc) {
  LogRig rig{9000};
  rig.power_up();
  constexpr std::uint16_t sizes[] = {1, 6, 7, 8, 34, 35, 36, 70, 256, 1791, 1792};
  for (const std::uint16_t size : sizes) {
    for (const std::uint32_t offset : {0U, 1U, 4095U, 9000U, 12'288U - size}) {
      expect_chunk(rig, offset, size);
    }
  }
}

TEST(LogTransfer, ATickHasOneReadOfThirtyFiveBytesAndFiveFramesAndThreeInASession) {
  LogRig rig{9000};
  rig.power_up();
  for (const bool session : {false, true}) {
    rig.right.session = session ? std::optional{LogRig::session} : std::nullopt;
    rig.ask(LogAction::read, 0, 1792);
    int ticks = 0;
    std::size_t frames = 0;
    for (; frames < 257 && ticks < 1000; ++ticks) {
      rig.step();
      frames += rig.bus.sent.size();
      EXPECT_LE(rig.watched.calls, 1);
      EXPECT_LE(rig.watched.bytes_read, 35U);
      EXPECT_LE(rig.bus.sent.size(), session ? 4U : 6U);  // the reply comes with the last ones
    }
    EXPECT_EQ(frames, 257U);
    EXPECT_LE(ticks, session ? 104 : 52);
  }
}

TEST(LogTransfer, TheBlockOfThePlanIsReadLikeTheRecord) {
  LogRig rig{9000};
  rig.power_up();
  constexpr std::uint16_t sizes[] = {1, 7, 12, 35, 36, 380};
  for (const std::uint16_t size : sizes) {
    for (const std::uint32_t offset : {0U, 1U, 200U, 380U - size}) {
      if (offset + size <= 380) {
        expect_chunk(rig, offset, size, LogAction::plan);
        expect_chunk(rig, offset, size, LogAction::read);
      }
    }
  }
  EXPECT_EQ(rig.refusal(LogAction::plan, 0, 0), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::plan, 0, 381), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::plan, 380, 1), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::plan, 0xFFFFFFFF, 1), LogFault::out_of_range);
}

TEST(LogTransfer, TheBlockOfThePlanNeedsNoFlash) {
  LogRig rig{9000};  // not yet looked through
  rig.right.flash_in_use = true;
  rig.ask(LogAction::plan, 0, 380);
  for (int i = 0; i < 11; ++i) {
    rig.step();
    EXPECT_EQ(rig.watched.calls, 0);
    EXPECT_LE(rig.bus.sent.size(), 6U);
  }
  EXPECT_TRUE(std::holds_alternative<protocol::LogReply>(rig.bus.sent.back())) << "55 frames, five a tick";
}

TEST(LogTransfer, ThePlanIsReadInSafeOnly) {
  LogRig rig{9000};
  rig.power_up();
  rig.right.safe = false;
  EXPECT_EQ(rig.refusal(LogAction::plan, 0, 12), LogFault::not_safe);
  rig.right.safe = true;
  rig.ask(LogAction::plan, 0, 380);
  rig.step();
  rig.right.safe = false;
  const auto reply = rig.reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->fault, LogFault::not_safe);
}

TEST(LogTransfer, ARefusedRequestLeavesTheReadThatIsUnderWay) {
  LogRig rig{9000};
  rig.power_up();
  rig.ask(LogAction::read, 0, 1792, 3);
  rig.step();
  rig.ask(LogAction::erase, LogRig::session, 0, 9);
  rig.ask(LogAction::read, 1'000'000, 10, 9);
  const auto refusal = rig.reply();
  ASSERT_TRUE(refusal && refusal->state == LogState::refused);
  EXPECT_EQ(refusal->tag, 9);
  EXPECT_EQ(refusal->fault, LogFault::out_of_range) << "of the newest one";
  const auto reply = rig.reply();
  ASSERT_TRUE(reply && reply->state == LogState::read);
  EXPECT_EQ(reply->tag, 3);
  EXPECT_EQ(reply->extra, 1792);
}

TEST(LogTransfer, AFrameThatFindsNoRoomOnTheBusComesAgain) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LogRig rig{9000, seed};
    rig.power_up();
    core::RandomStream random{seed};
    rig.ask(LogAction::read, 100, 1792);
    std::vector<protocol::LogData> heard;
    std::optional<protocol::LogReply> reply;
    for (int i = 0; i < 10'000 && !reply; ++i) {
      rig.room_a_tick = random.whole(0, 3);
      rig.step();
      for (const auto& message : rig.bus.sent) {
        const auto* data = std::get_if<protocol::LogData>(&message);
        data != nullptr ? heard.push_back(*data) : void(reply = std::get<protocol::LogReply>(message));
      }
    }
    ASSERT_TRUE(reply);
    ASSERT_EQ(heard.size(), 256U);
    for (std::size_t i = 0; i < 1792; ++i) {
      ASSERT_EQ(heard[i / 7].index, i / 7);
      ASSERT_EQ(heard[i / 7].bytes[i % 7], rig.record[100 + i]);
    }
  }
}

TEST(LogTransfer, WhoeverNeedsTheFlashGoesFirst) {
  LogRig rig{9000};
  rig.power_up();
  rig.ask(LogAction::read, 0, 1792);
  rig.right.flash_in_use = true;
  for (int i = 0; i < 500; ++i) {
    rig.step();
    EXPECT_EQ(rig.watched.calls, 0);
    EXPECT_TRUE(rig.bus.sent.empty());
  }
  rig.right.flash_in_use = false;
  const auto reply = rig.reply();
  EXPECT_TRUE(reply && reply->state == LogState::read);
}

TEST(LogTransfer, AFlashThatIsBusyIsWaitedForAndOneThatStaysBusyIsGivenUp) {
  LogRig rig{9000};
  rig.power_up();
  rig.flash.set_stays_busy(true);
  rig.ask(LogAction::read, 0, 100);
  EXPECT_FALSE(rig.reply(1500));
  rig.flash.set_stays_busy(false);
  auto reply = rig.reply();
  EXPECT_TRUE(reply && reply->state == LogState::read);
  rig.flash.set_stays_busy(true);
  rig.ask(LogAction::read, 0, 100);
  reply = rig.reply(2500);
  EXPECT_TRUE(reply && reply->fault == LogFault::flash_failed);
}

TEST(LogTransfer, WhatIsNotThereIsRefused) {
  LogRig rig{9000};
  rig.power_up();
  EXPECT_EQ(rig.refusal(LogAction::read, 0, 0), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::read, 0, 1793), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::read, 12'288, 1), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::read, 12'287, 2), LogFault::out_of_range);
  EXPECT_EQ(rig.refusal(LogAction::read, 0xFFFFFFFF, 1792), LogFault::out_of_range);
  EXPECT_TRUE(rig.data.empty());
  LogRig nothing{0};
  nothing.power_up();
  EXPECT_EQ(nothing.refusal(LogAction::read, 0, 1), LogFault::out_of_range);
}

TEST(LogTransfer, BeforeTheLookThroughTheFlashHasEndedNothingIsSaid) {
  LogRig rig{9000};
  rig.right.session = LogRig::session;
  for (const auto action : {LogAction::info, LogAction::read, LogAction::erase}) {
    rig.ask(action, LogRig::session, 10);
    rig.step();
    rig.world.time += LogTransfer::reply_gap;
    ASSERT_FALSE(rig.bus.sent.empty());
    EXPECT_EQ(std::get<protocol::LogReply>(rig.bus.sent[0]).fault, LogFault::not_counted_yet);
  }
}

TEST(LogTransfer, AFlashThatDoesNotAnswerIsSaidSo) {
  LogRig rig{9000};
  rig.power_up();
  rig.flash.set_answers(false);
  EXPECT_EQ(rig.refusal(LogAction::read, 0, 10), LogFault::flash_failed);
  LogRig dead{9000};
  dead.flash.set_answers(false);
  dead.step();
  EXPECT_EQ(dead.refusal(LogAction::info), LogFault::flash_failed);
}

TEST(LogTransfer, OutsideSafeEverythingIsRefusedAndAReadUnderWayEnds) {
  LogRig rig{9000};
  rig.power_up();
  rig.right.session = LogRig::session;
  rig.ask(LogAction::read, 0, 1792);
  EXPECT_FALSE(rig.reply(5));
  rig.right.safe = false;
  rig.data.clear();
  const auto reply = rig.reply();
  EXPECT_TRUE(reply && reply->fault == LogFault::not_safe);
  for (const auto action : {LogAction::info, LogAction::read, LogAction::erase}) {
    EXPECT_EQ(rig.refusal(action, 0, 10), LogFault::not_safe);
  }
  EXPECT_FALSE(rig.reply(100));
  EXPECT_TRUE(rig.data.empty());
  EXPECT_EQ(rig.bytes_in_flash(), 9000U);
}

TEST(LogTransfer, ANewRequestTakesThePlaceOfTheOldOne) {
  LogRig rig{9000};
  rig.power_up();
  rig.ask(LogAction::read, 0, 1792, 1);
  EXPECT_FALSE(rig.reply(10));
  rig.ask(LogAction::info, 0, 0, 2);
  const auto info = rig.reply();
  EXPECT_TRUE(info && info->state == LogState::ready && info->tag == 2);
  rig.data.clear();
  EXPECT_FALSE(rig.reply(100));
  EXPECT_TRUE(rig.data.empty());
  rig.ask(LogAction::read, 0, 1792, 1);
  EXPECT_FALSE(rig.reply(10));
  expect_chunk(rig, 700, 70);
}

TEST(LogTransfer, RepliesAreAtLeastTwentyMillisecondsApartWhoeverAsks) {
  LogRig rig{9000};
  rig.power_up();
  int replies = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.ask(LogAction::info);
    rig.step();
    replies += static_cast<int>(rig.bus.sent.size());
  }
  EXPECT_EQ(replies, 50);
}

}  // namespace
}  // namespace fantail::avionics
