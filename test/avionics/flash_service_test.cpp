// SPDX-License-Identifier: MIT

#include "avionics/flash_service.hpp"

#include "recorder_rig.hpp"
#include "test.hpp"
#include "transfer_rig.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;

struct Fresh : FlashRig {
  WatchedFlash watched{flash};
  FlashService service{watched};
  using FlashRig::FlashRig;
  void step() {
    watched.calls = 0;
    watched.bytes_read = 0;
    service.update(world.time, true);
    world.time += tick;
  }
};

TEST(FlashService, FindsOutTheRoomOfABlankFlashAfterCountingThePowerUp) {
  Fresh rig;
  ASSERT_TRUE(rig.service.load_plan(rig.world.time).has_value());
  while (!rig.service.flights().free_bytes()) {
    EXPECT_FALSE(rig.service.flights().failed());
    rig.step();
    ASSERT_LT(rig.world.time, 1s);
  }
  EXPECT_EQ(rig.service.boots().count(), 1U);
  EXPECT_EQ(*rig.service.flights().free_bytes(), 65'536U - 4U * 4096U);
}

TEST(FlashService, WhatIsInUseAndASectorThatWasSpoiltBehindItAreNotFree) {
  Fresh rig;
  rig.flash.cells()[16'384] = std::byte{0};            // the first byte of the flight region
  rig.flash.cells()[5 * 4096 + 15] = std::byte{0xFE};  // the last one that is looked at
  rig.flash.cells()[6 * 4096 + 16] = std::byte{0};     // beyond it, in the sector where the next flight would begin
  rig.flash.cells()[0] = std::byte{0};                 // not of the flight region
  for (int i = 0; i < 100; ++i) {
    rig.step();
  }
  EXPECT_EQ(rig.service.flights().free_bytes(), 9U * 4096U);
}

TEST(FlashService, AWholeW25Q128IsLookedThroughInFiveSeconds) {
  Fresh rig{hal::sim::flash_16_mib};
  while (!rig.service.flights().finished() && rig.world.time < 10s) {
    rig.step();
  }
  EXPECT_LT(rig.world.time, 5s);
  EXPECT_EQ(rig.service.flights().free_bytes(), 4092U * 4096U);
}

TEST(FlashService, AsksOneThingATickWhileEverythingIsWanted) {
  Fresh rig;
  ASSERT_TRUE(rig.service.load_plan(rig.world.time).has_value());
  const Bytes block = block_of(numbered_plan(5));
  rig.service.transfer().receive(
      rig.world.time, {.size = static_cast<std::uint16_t>(block.size()), .block_crc = protocol::plan_block_crc(block)},
      true);
  for (std::size_t index = 0; 7 * index < block.size(); ++index) {
    protocol::PlanData frame{.index = static_cast<std::uint8_t>(index)};
    std::copy_n(block.begin() + static_cast<std::ptrdiff_t>(7 * index),
                std::min<std::size_t>(7, block.size() - 7 * index), frame.bytes.begin());
    rig.service.transfer().receive(rig.world.time, frame, true);
  }
  bool room_was_first = false;
  std::optional<core::FlightPlan> taken;
  for (int i = 0; i < 200; ++i) {
    rig.step();
    ASSERT_LE(rig.watched.calls, 1);
    ASSERT_LE(rig.watched.bytes_read, 256U);
    const auto plan = rig.service.transfer().take_plan();
    taken = plan ? plan : taken;
    EXPECT_FALSE(taken && !rig.service.boots().finished()) << "the count of the power-up comes first";
    room_was_first = room_was_first || (!taken && rig.service.flights().finished());
  }
  EXPECT_TRUE(taken.has_value());
  EXPECT_TRUE(rig.service.flights().finished());
  EXPECT_FALSE(room_was_first);
}

TEST(FlashService, APlanThatComesDuringTheLookForRoomIsWrittenAndTheLookGoesOn) {
  TransferRig rig;
  const Fresh other{rig.cells()};
  rig.send(block_of(numbered_plan(5)));
  rig.run(100);
  EXPECT_EQ(rig.state(), protocol::TransferState::stored);
  EXPECT_EQ(rig.service.flights().free_bytes(), 12U * 4096U);
}

TEST(FlashService, ADeadFlashFailsEveryUserByNameAndNobodyWaits) {
  for (const bool silent : {true, false}) {
    Fresh rig;
    rig.flash.set_answers(!silent);
    rig.flash.set_stays_busy(!silent);
    for (int i = 0; i < 5000; ++i) {
      rig.step();
      ASSERT_LE(rig.watched.calls, 1);
    }
    EXPECT_TRUE(rig.service.boots().failed());
    EXPECT_TRUE(rig.service.flights().failed());
    EXPECT_FALSE(rig.service.flights().free_bytes().has_value());
    EXPECT_EQ(rig.service.load_plan(rig.world.time)->flash_failed, true);
  }
}

TEST(FlashService, AFlashThatIsTooSmallFailsEveryUserByName) {
  Fresh rig{hal::FlashGeometry{.size = 16'384, .sector_size = 4096, .page_size = 256}};
  EXPECT_TRUE(rig.service.load_plan(rig.world.time)->flash_failed);
  rig.step();
  rig.step();
  EXPECT_TRUE(rig.service.boots().failed());
  EXPECT_TRUE(rig.service.flights().failed());
}

TEST(FlashService, NeedsTheRoomOfTheRecorderOfOneBlockAndLittleMore) {
  EXPECT_LT(sizeof(FlashService), sizeof(Recorder) + 2048U);
}

// A flash that does not keep what it is given, and does not say so.

using core::Phase;

constexpr std::uint32_t sector = 4096;

struct BadPage : testing::Test {
  hal::sim::WorldSide world;
  hal::sim::Flash flash{world, one_mib, {}};
  RecorderRig rig{flash, 5, &world};
  const std::uint32_t begin = flash_map(one_mib)->flight_begin;

  void fly() {
    rig.run(Phase::armed, 1000);
    rig.run(Phase::launched, 2000);
    rig.tick(Phase::armed);
    rig.settle(Phase::armed);
  }
  /// What a reader finds: every record's number, each once and rising.
  std::vector<std::uint32_t> found() {
    Bytes read(region_of(flash).size());
    for (std::size_t at = 0; at < read.size(); at += 256) {
      EXPECT_EQ(flash.read(begin + static_cast<std::uint32_t>(at), std::span{read}.subspan(at, 256)),
                hal::FlashResult::ok);
    }
    std::vector<std::uint32_t> numbers;
    for (const Record& record : records_in(read)) {
      EXPECT_TRUE(numbers.empty() || record.sequence > numbers.back()) << "a record twice would be another flight";
      numbers.push_back(record.sequence);
    }
    return numbers;
  }
  [[nodiscard]] std::uint32_t bad_pages() const { return rig.service.flights().bad_pages(); }
};

TEST_F(BadPage, EveryPageIsReadBackAndASoundFlashHasNone) {
  fly();
  const auto numbers = found();
  EXPECT_EQ(numbers.back() + 1, numbers.size());
  EXPECT_EQ(bad_pages(), 0U);
  EXPECT_FALSE(rig.service.facts().has_bad_pages);
}

TEST_F(BadPage, OneBitThatDoesNotProgramCostsTheRecordAcrossItsBeginningAndNoOther) {
  for (int bit = 0; bit < 8; ++bit) {
    flash.stick(begin + 20 * sector / 2 + 100, std::byte{1} << bit, std::byte{1} << bit);
  }
  fly();
  const auto numbers = found();
  EXPECT_EQ(numbers.back() + 1 - numbers.size(), 1U) << "lost";
  EXPECT_EQ(bad_pages(), 1U);
  EXPECT_TRUE(rig.service.facts().has_bad_pages);
  EXPECT_FALSE(rig.service.facts().failed);
}

TEST_F(BadPage, OfAWornOutSectorNothingIsLostButTheRecordBeforeIt) {
  flash.wear_out(begin + 10 * sector);
  fly();
  const auto numbers = found();
  EXPECT_LE(numbers.back() + 1 - numbers.size(), 1U);
  EXPECT_EQ(bad_pages(), 1U);
  EXPECT_GT(rig.service.flights().used_bytes(), 11 * sector);
}

TEST_F(BadPage, ThreeBadSectorsInARowArePassedOverAndNineAreAFailedFlash) {
  for (std::uint32_t i = 10; i < 13; ++i) {
    flash.wear_out(begin + i * sector);
  }
  fly();
  const auto numbers = found();
  EXPECT_LE(numbers.back() + 1 - numbers.size(), 1U);
  EXPECT_FALSE(rig.service.facts().failed);

  hal::sim::Flash worn{world, one_mib, {}};
  for (std::uint32_t i = 4; i < 13; ++i) {
    worn.wear_out(begin + i * sector);
  }
  RecorderRig other{worn, 6, &world};
  other.run(Phase::armed, 1000);
  other.run(Phase::launched, 2000);
  EXPECT_TRUE(other.service.facts().failed);
  EXPECT_FALSE(other.service.recorder().busy());
}

}  // namespace

}  // namespace fantail::avionics
