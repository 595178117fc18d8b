// SPDX-License-Identifier: MIT
// The erase of the flight record: on a bench's word only, and never outside Safe and an open session.

#include "log_rig.hpp"
#include "properties.hpp"

namespace fantail::avionics {
namespace {

using protocol::LogAction;
using protocol::LogFault;
using protocol::LogState;

struct LogErase : testing::Test {
  LogRig rig{40'000};  // ten sectors of twelve
  void SetUp() override {
    rig.power_up();
    rig.right.session = LogRig::session;
  }
};

TEST_F(LogErase, EmptiesTheRegionAndNothingElseAndTellsHowItGoesOn) {
  rig.ask_to_erase();
  std::uint32_t left = 40'960;
  std::optional<protocol::LogReply> reply;
  while ((reply = rig.reply()) && reply->state == LogState::erasing) {
    EXPECT_LE(reply->number, left);
    left = reply->number;
  }
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->state, LogState::erased);
  EXPECT_EQ(reply->number, 0U);
  EXPECT_EQ(reply->extra, 12 * 4);
  EXPECT_EQ(rig.bytes_in_flash(), 0U);
  EXPECT_TRUE(std::ranges::all_of(rig.flash.cells().first(LogRig::region_begin),
                                  [](std::byte byte) { return byte == std::byte{0x5A}; }));
  rig.ask(LogAction::info);
  reply = rig.reply();
  EXPECT_TRUE(reply && reply->state == LogState::ready && reply->number == 0);
}

TEST_F(LogErase, OfNothingIsDoneAtOnce) {
  LogRig nothing{0};
  nothing.power_up();
  nothing.right.session = LogRig::session;
  nothing.ask_to_erase();
  const auto reply = nothing.reply();
  EXPECT_TRUE(reply && reply->state == LogState::erased);
  EXPECT_EQ(nothing.flash.begun(), 0U);
}

TEST_F(LogErase, IsRefusedWithoutASessionAndWhileTheFlashIsInUse) {
  rig.right.session.reset();
  EXPECT_EQ(rig.refusal(LogAction::erase, LogRig::session), LogFault::no_session);
  rig.right = {.safe = true, .session = LogRig::session, .flash_in_use = true};
  EXPECT_EQ(rig.refusal(LogAction::erase, LogRig::session), LogFault::busy);
  EXPECT_EQ(rig.bytes_in_flash(), 40'000U);
}

TEST_F(LogErase, IsRefusedInTheSessionOfAnotherBenchAndStopsWhenTheNextOneIsAnothers) {
  EXPECT_EQ(rig.refusal(LogAction::erase, LogRig::session + 1), LogFault::no_session);
  EXPECT_EQ(rig.refusal(LogAction::erase, LogRig::session + 0x10000), LogFault::no_session);
  EXPECT_EQ(rig.bytes_in_flash(), 40'000U);
  rig.ask_to_erase();
  rig.step();
  rig.right.session = LogRig::session + 1;
  std::optional<protocol::LogReply> reply;
  while ((reply = rig.reply(200)) && reply->state != LogState::refused) {
  }
  EXPECT_TRUE(reply && reply->fault == LogFault::no_session);
  EXPECT_GT(rig.bytes_in_flash(), 0U);
}

TEST_F(LogErase, ARefusedRequestDoesNotStopItAndItsEndIsToldUnderItsOwnTag) {
  rig.ask_to_erase();
  std::optional<protocol::LogReply> reply;
  int refusals = 0;
  for (int i = 0; i < 5'000 && !(reply && reply->state == LogState::erased); ++i) {
    if (i % 21 == 0) {
      rig.ask(LogAction::erase, LogRig::session + 1, 0, 9);
    }
    const auto next = rig.reply(1);
    reply = next ? next : reply;
    if (next && next->state == LogState::refused) {
      EXPECT_EQ(next->tag, 9);
      EXPECT_EQ(next->fault, LogFault::no_session);
      refusals += 1;
    } else if (next) {
      EXPECT_EQ(next->tag, 3);
    }
  }
  EXPECT_TRUE(reply && reply->state == LogState::erased);
  EXPECT_GE(refusals, 3);
  EXPECT_EQ(rig.bytes_in_flash(), 0U);
}

TEST_F(LogErase, NothingIsReadMeanwhile) {
  rig.ask_to_erase();
  rig.step();
  rig.step();
  rig.world.time += LogTransfer::reply_gap;
  rig.ask(LogAction::read, 0, 10, 7);
  rig.step();
  ASSERT_EQ(rig.bus.sent.size(), 1U);
  const auto reply = std::get<protocol::LogReply>(rig.bus.sent[0]);
  EXPECT_EQ(reply.fault, LogFault::busy);
  EXPECT_EQ(reply.tag, 7);
}

TEST_F(LogErase, StopsWithTheSessionOrWithSafeAndLeavesTheBeginningWhole) {
  for (const bool session_ends : {true, false}) {
    LogRig cut{40'000};
    cut.power_up();
    cut.right.session = LogRig::session;
    cut.ask_to_erase();
    for (int i = 0; i < 17; ++i) {
      cut.step();
    }
    if (session_ends) {
      cut.right.session.reset();
    } else {
      cut.right.safe = false;
    }
    std::optional<protocol::LogReply> reply;
    while ((reply = cut.reply(200)) && reply->state != LogState::refused) {
    }
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->fault, session_ends ? LogFault::no_session : LogFault::not_safe);
    EXPECT_FALSE(cut.flights.erasing());
    const std::uint32_t kept = cut.flights.used_bytes();
    EXPECT_GT(kept, 0U);
    EXPECT_LT(kept, 40'960U);
    EXPECT_TRUE(std::ranges::equal(cut.region().first(kept), std::span{cut.record}.first(kept)));
    EXPECT_TRUE(
        std::ranges::all_of(cut.region().subspan(kept), [](std::byte byte) { return byte == std::byte{0xFF}; }));
    EXPECT_TRUE(cut.flights.open().has_value());  // and a flight finds its place

    cut.right = {.safe = true, .session = LogRig::session};
    cut.ask_to_erase();
    while ((reply = cut.reply()) && reply->state == LogState::erasing) {
    }
    EXPECT_TRUE(reply && reply->state == LogState::erased);
    EXPECT_EQ(cut.bytes_in_flash(), 0U);
  }
}

TEST_F(LogErase, AFlashThatFailsMeanwhileIsSaidSo) {
  rig.ask_to_erase();
  ASSERT_TRUE(rig.reply());
  rig.flash.set_answers(false);
  const auto reply = rig.reply();
  EXPECT_TRUE(reply && reply->state == LogState::refused && reply->fault == LogFault::flash_failed);
}

// A sector's erase may be begun only in Safe and in an open session, on a request that came in such a tick too.
RC_GTEST_PROP(LogEraseProperty, WhateverIsAskedNothingIsErasedOutsideSafeAndAnOpenSession, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  LogRig rig{static_cast<std::size_t>(random.whole(0, 45'000)), seed};
  bool allowed = false;  // by a request, since the right to it was last interrupted
  for (int i = 0; i < 2'000; ++i) {
    if (random.chance(0.02)) {
      rig.right.safe = random.chance(0.7);
    }
    if (random.chance(0.02)) {
      rig.right.session = random.chance(0.5) ? std::optional{LogRig::session} : std::nullopt;
    }
    if (random.chance(0.02)) {
      rig.right.flash_in_use = random.chance(0.2);
    }
    const bool may_erase = rig.right.safe && rig.right.session;
    allowed = allowed && may_erase;
    if (random.chance(0.05)) {
      const auto action = static_cast<LogAction>(random.whole(0, 2));
      const bool own = random.chance(0.5);
      const auto offset = own ? LogRig::session : static_cast<std::uint32_t>(random.whole(5'000, 50'000));
      rig.ask(action, offset, static_cast<std::uint16_t>(random.whole(0, 4095)));
      allowed = allowed || (action == LogAction::erase && own && may_erase);
    }
    rig.room_a_tick = random.whole(0, 6);
    const std::uint64_t before = rig.flash.begun();
    rig.step();
    RC_ASSERT(rig.flash.begun() == before || allowed);
  }
}

}  // namespace
}  // namespace fantail::avionics
