// SPDX-License-Identifier: MIT
#include "avionics/recorder.hpp"

#include "recorder_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::LogEnd;
using protocol::LogEventKind;
using protocol::LogRecord;

// An image of 48 kB has to hold it beside everything else.
static_assert(sizeof(Recorder) < 40'000);
static_assert(std::is_copy_assignable_v<core::Autopilot>, "the law that flies half a second behind is a copy");

std::size_t count(std::span<const std::byte> log, LogRecord type) { return avionics::count(records_in(log), type); }

void expect_ended(std::span<const std::byte> log, LogEnd end) {
  const auto events = events_in(log);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, LogEventKind::recording_ended);
  EXPECT_EQ(events.back().value, static_cast<std::uint8_t>(end));
}

std::uint32_t number_dropped(std::span<const std::byte> log) {
  std::uint32_t dropped = 0;
  for (const protocol::LogEvent& event : events_in(log)) {
    dropped += event.kind == LogEventKind::records_dropped ? event.number : 0;
  }
  return dropped;
}

struct RecorderTest : testing::Test {
  hal::sim::Flash flash{one_mib};
  RecorderRig rig{flash};
  [[nodiscard]] std::span<const std::byte> log() { return region_of(flash); }
};

TEST_F(RecorderTest, AnArmedRocketWritesNothingHoweverLongItStands) {
  rig.run(Phase::armed, 20'000);
  EXPECT_TRUE(rig.noting.programs.empty());
}

TEST_F(RecorderTest, KeepsTheLastHalfSecondBeforeTheLaunch) {
  rig.run(Phase::armed, 5000);
  const core::Microseconds launch = rig.time + tick;
  rig.run(Phase::launched, 200);
  rig.settle(Phase::armed);
  protocol::LogFrameReader reader{log()};
  const auto header = reader.next();
  ASSERT_TRUE(header.has_value());
  EXPECT_EQ(header->head.type, static_cast<std::uint8_t>(LogRecord::header));
  EXPECT_EQ(header->head.time, launch - 500 * tick);
  EXPECT_EQ(count(log(), LogRecord::tick), 500U + 200U + 1U);
}

TEST_F(RecorderTest, ALaunchRightAfterArmingIsRecordedFromTheFirstTickAfterIt) {
  rig.tick(Phase::armed);
  rig.run(Phase::launched, 50);
  rig.settle(Phase::armed);
  EXPECT_EQ(count(log(), LogRecord::tick), 50U + 1U);
  EXPECT_EQ(count(log(), LogRecord::checkpoint), 1U);
}

TEST_F(RecorderTest, ACheckpointStandsDirectlyBeforeATick) {
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 12'000);
  const std::vector<Record> records = records_in(log());
  std::size_t checkpoints = 0;
  for (std::size_t i = 0; i + 1 < records.size(); ++i) {
    if (records[i].type == static_cast<std::uint8_t>(LogRecord::checkpoint)) {
      EXPECT_EQ(records[i + 1].type, static_cast<std::uint8_t>(LogRecord::tick));
      checkpoints += 1;
    }
  }
  EXPECT_EQ(checkpoints, 12U);
  EXPECT_EQ(count(log(), LogRecord::header), 3U);
}

TEST(Recorder, EndsHalfAMinuteAfterControlHasEnded) {
  hal::sim::Flash large{{.size = 4U << 20U, .sector_size = 4096, .page_size = 256}};
  RecorderRig other{large};
  other.run(Phase::armed, 600);
  other.run(Phase::controlling, 100);
  other.run(Phase::finished, 30'000);
  EXPECT_TRUE(other.service.recorder().busy());
  other.run(Phase::finished, 1000);
  EXPECT_FALSE(other.service.recorder().busy());
  expect_ended(region_of(large), LogEnd::flight_over);
  EXPECT_EQ(count(region_of(large), LogRecord::tick), 500U + 100U + 30'001U);
  const std::size_t programs = other.noting.programs.size();
  other.run(Phase::finished, 2000);
  EXPECT_EQ(other.noting.programs.size(), programs);
}

TEST_F(RecorderTest, ALaunchThatWasNoneEndsItsRecordAndTheNextOneHasItsOwn) {
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 300);
  rig.run(Phase::armed, 3000);
  EXPECT_FALSE(rig.service.recorder().busy());
  expect_ended(log(), LogEnd::returned_to_pad);
  EXPECT_EQ(count(log(), LogRecord::tick), 500U + 300U + 1U);
  const std::size_t first = rig.noting.programs.size();
  rig.run(Phase::launched, 400);
  rig.run(Phase::armed, 600);
  ASSERT_GT(rig.noting.programs.size(), first);
  const std::size_t second = rig.noting.programs[first].address - flash_map(one_mib)->flight_begin;
  EXPECT_EQ(second % 4096, 0U);
  EXPECT_EQ(records_in(log().subspan(second)).front().sequence, 0U);
  EXPECT_EQ(events_in(log().subspan(second)).front().number, second / 4096);
  EXPECT_EQ(count(log().subspan(second), LogRecord::tick), 500U + 400U + 1U);
  expect_ended(log(), LogEnd::returned_to_pad);
}

TEST_F(RecorderTest, TheNextPowerUpRecordsBehindTheLastFlight) {
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 1000);
  const Bytes before{log().begin(), log().end()};
  RecorderRig again{flash, 2};
  again.run(Phase::armed, 600);
  again.run(Phase::launched, 1000);
  ASSERT_FALSE(again.noting.programs.empty());
  const std::size_t second = again.noting.programs.front().address - flash_map(one_mib)->flight_begin;
  const NotingFlash::Program& last = rig.noting.programs.back();
  const std::size_t first_end = last.address + last.bytes.size() - flash_map(one_mib)->flight_begin;
  EXPECT_EQ(second, (first_end + 4095) / 4096 * 4096);
  EXPECT_TRUE(std::ranges::equal(log().first(second), std::span{before}.first(second)));
}

TEST(Recorder, AFullFlashEndsTheRecordWithAWholeOneThatSaysSo) {
  for (std::uint32_t extra = 0; extra < 40; ++extra) {
    hal::sim::Flash small{small_flash};
    RecorderRig rig{small, extra};
    rig.run(Phase::armed, 20 + static_cast<int>(extra));
    rig.run(Phase::controlling, 3000);
    EXPECT_FALSE(rig.service.recorder().busy());
    const auto region = region_of(small);
    expect_ended(region, LogEnd::flash_full);
    protocol::LogFrameReader reader{region};
    std::uint32_t sequence = 0;
    std::size_t end = 0;
    while (const auto frame = reader.next()) {
      EXPECT_EQ(frame->head.sequence, sequence);
      sequence += 1;
      end = frame->position;
    }
    EXPECT_EQ(reader.foreign_bytes(), 0U);
    EXPECT_GT(end, region.size() - 2048);
    EXPECT_EQ(rig.service.flights().free_bytes(), 0U);
    // And it is no reason not to fly on.
    rig.run(Phase::finished, 100);
    rig.run(Phase::armed, 600);
    rig.run(Phase::launched, 600);
    EXPECT_FALSE(rig.service.recorder().busy());
  }
}

TEST(Recorder, AFlashWithoutRoomForTheHalfSecondBeforeLaunchIsLeftAsItIs) {
  hal::sim::Flash smaller{{.size = 13U * 4096U, .sector_size = 4096, .page_size = 256}};
  RecorderRig rig{smaller};
  ASSERT_EQ(rig.service.flights().free_bytes(), 9U * 4096U);
  rig.run(Phase::armed, 600);
  rig.run(Phase::controlling, 3000);
  EXPECT_TRUE(rig.noting.programs.empty());
  EXPECT_FALSE(rig.service.recorder().busy());
}

TEST(Recorder, AtThreeMillisecondsAPageNoTickIsLost) {
  hal::sim::WorldSide world;
  hal::sim::Flash flash{world, one_mib, {.program = hal::Microseconds{3'000}, .erase = hal::Microseconds{400'000}}};
  RecorderRig rig{flash, 3, &world};
  rig.run(Phase::armed, 2000);
  rig.run(Phase::launched, 11'000);
  rig.tick(Phase::armed);
  rig.settle(Phase::armed);
  rig.run(Phase::safe, 4);
  EXPECT_FALSE(flash.busy());
  EXPECT_EQ(rig.service.recorder().ticks_dropped(), 0U);
  EXPECT_EQ(count(region_of(flash), LogRecord::tick), 500U + 11'000U + 1U);
  expect_ended(region_of(flash), LogEnd::returned_to_pad);
}

TEST(Recorder, WhatFindsNoRoomIsCountedAndMissingBetweenTwoNumbers) {
  hal::sim::Flash flash{one_mib};
  RecorderRig rig{flash};
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 1000);
  flash.set_stays_busy(true);
  rig.run(Phase::launched, 1500);
  flash.set_stays_busy(false);
  rig.run(Phase::launched, 3000);
  rig.tick(Phase::armed);
  rig.settle(Phase::armed);
  const auto log = region_of(flash);
  const std::uint32_t dropped = rig.service.recorder().ticks_dropped();
  EXPECT_GT(dropped, 1500U - TickQueue::capacity_of_one_gyro);
  EXPECT_EQ(count(log, LogRecord::tick), 500U + 5500U + 1U - dropped);
  const std::uint32_t told = number_dropped(log);
  EXPECT_GE(told, dropped);
  std::vector<Record> records = records_in(log);
  std::uint32_t missing = 0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const std::uint32_t gap = records[i].sequence - records[i - 1].sequence - 1;
    missing += gap;
    if (gap > 0) {  // the event that says so, and then a state from which a replay can go on
      EXPECT_EQ(records[i].type, static_cast<std::uint8_t>(LogRecord::event));
      const auto next_tick = std::ranges::find(records.begin() + static_cast<std::ptrdiff_t>(i), records.end(),
                                               static_cast<std::uint8_t>(LogRecord::tick), &Record::type);
      EXPECT_EQ(std::prev(next_tick)->type, static_cast<std::uint8_t>(LogRecord::checkpoint));
    }
  }
  EXPECT_EQ(missing, told);
}

TEST(Recorder, AFlashThatDiesIsGivenUpAndNobodyWaits) {
  hal::sim::Flash flash{one_mib};
  RecorderRig rig{flash};
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 1000);
  const std::size_t written = records_in(region_of(flash)).size();
  flash.set_stays_busy(true);
  rig.run(Phase::launched, 3000);
  EXPECT_FALSE(rig.service.recorder().busy());
  EXPECT_TRUE(rig.service.facts().failed);
  EXPECT_EQ(records_in(region_of(flash)).size(), written);
  rig.run(Phase::armed, 600);
  rig.run(Phase::launched, 600);
  EXPECT_FALSE(rig.service.recorder().busy());
}

TEST(Recorder, AsksTheFlashForOneThingATickAtMost) {
  hal::sim::Flash flash{one_mib};
  WatchedFlash watched{flash};
  RecorderRig rig{watched};
  rig.run(Phase::armed, 600);
  for (int i = 0; i < 2000; ++i) {
    watched.calls = 0;
    rig.tick(Phase::launched);
    ASSERT_LE(watched.calls, 1);
  }
}

}  // namespace
}  // namespace fantail::avionics
