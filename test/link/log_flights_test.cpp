// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "link/arm_steps.hpp"
#include "link/avionics_link.hpp"
#include "link/log_download.hpp"
#include "link/made_record.hpp"
#include "protocol/log_notes.hpp"
#include "system/folder.hpp"
#include "test.hpp"
#include "text/output_folder.hpp"

namespace fantail::link {
namespace {

using protocol::append;
using test::fill_sector;
using test::flight;
using test::header_of;
using test::tick_of;
using Bytes = std::vector<std::byte>;

TEST(LogFlights, OfErasedFlashAndOfForeignBytesThereAreNone) {
  EXPECT_TRUE(split_flights({}).empty());
  EXPECT_TRUE(split_flights(Bytes(5000, std::byte{0xFF})).empty());
  EXPECT_TRUE(split_flights(Bytes(5000, std::byte{0x42})).empty());
}

TEST(LogFlights, EachIsCutOutWithoutTheErasedFlashBehindIt) {
  const Bytes one = flight(0, 300, "first");
  const Bytes two = flight(4, 10, "second");
  Bytes record = one;
  fill_sector(record);
  const std::size_t begin = record.size();
  append(record, two);
  fill_sector(record);
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[0].begin, 0U);
  EXPECT_EQ(flights[0].end, one.size());
  EXPECT_EQ(flights[0].vehicle, "first");
  EXPECT_EQ(flights[0].power_up, 7U);
  EXPECT_EQ(flights[0].records, 301U);
  EXPECT_DOUBLE_EQ(flights[0].duration_s(), 0.3);
  EXPECT_TRUE(flights[0].intact());
  EXPECT_EQ(flights[1].begin, begin);
  EXPECT_EQ(flights[1].end, begin + two.size());
  EXPECT_EQ(flights[1].vehicle, "second");
  EXPECT_TRUE(flights[1].intact());
}

TEST(LogFlights, ADamagedRecordIsCountedAndTheFlightStaysOne) {
  Bytes record = flight(0, 100);
  record[record.size() / 2] ^= std::byte{1};
  fill_sector(record);
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 1U);
  EXPECT_EQ(flights[0].records, 100U);
  EXPECT_EQ(flights[0].missing_records, 1U);
  EXPECT_EQ(flights[0].damaged_bytes, tick_of(1).size());
  EXPECT_FALSE(flights[0].intact());
}

TEST(LogFlights, WhatAPowerCutLeftBelongsToTheFlightBeforeIt) {
  Bytes record = flight(0, 100);
  const Bytes torn = tick_of(101);
  append(record, std::span{torn}.first(17));
  const std::size_t end = record.size();
  fill_sector(record);
  append(record, flight(1, 5));
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[0].end, end);
  EXPECT_EQ(flights[0].cut_off_bytes, 17U);
  EXPECT_TRUE(flights[0].intact()) << "a record that was never finished is no damage";
  EXPECT_TRUE(flights[1].intact());
}

TEST(LogFlights, DamageBeforeTheLastRecordIsNoneThatWasCutOff) {
  Bytes record = flight(0, 100);
  std::fill(record.end() - 500, record.end(), std::byte{});
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 1U);
  EXPECT_EQ(flights[0].cut_off_bytes, 0U);
  EXPECT_GE(flights[0].damaged_bytes, 500U);
}

TEST(LogFlights, WhatTheRecorderLeftOutIsNotMissing) {
  Bytes record = flight(0, 10);
  const auto dropped = pack(protocol::LogEvent{.kind = protocol::LogEventKind::records_dropped, .number = 5});
  append(record, protocol::frame({.type = 4, .length = dropped.size(), .sequence = 17}, dropped));
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 1U);
  EXPECT_EQ(flights[0].missing_records, 1U);
}

TEST(LogFlights, AFlightWithoutItsFirstHeaderIsToldFromTheOneBeforeByItsNumbers) {
  Bytes record = flight(0, 100);
  fill_sector(record);
  Bytes second;
  for (std::uint32_t i = 5; i < 50; ++i) {
    append(second, tick_of(i));
  }
  append(record, second);
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[1].missing_records, 5U);
  EXPECT_FALSE(flights[1].power_up.has_value());
}

TEST(LogFlights, AHeaderOfAnotherFlightBeginsOneWhateverItsNumber) {
  Bytes record = flight(0, 100);
  append(record, header_of(500, 9, "other"));
  append(record, tick_of(501));
  const auto flights = split_flights(record);
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_TRUE(flights[0].intact());
  EXPECT_EQ(flights[1].vehicle, "other");
  EXPECT_EQ(flights[1].missing_records, 500U);
}

std::vector<std::byte> bytes(std::size_t count, int first) {
  std::vector<std::byte> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = static_cast<std::byte>(static_cast<std::size_t>(first) + i);
  }
  return out;
}

TEST(LogPart, GoesOnWhereTheOneBeforeItEndedAndGoesAwayWhenItIsDone) {
  const test::Folder folder;
  const std::string path = folder / "deep/er/record.part";
  {
    LogPart part{path};
    EXPECT_EQ(part.size(), 0U);
    part.append(bytes(300, 1));
  }
  LogPart part{path};
  EXPECT_EQ(part.size(), 300U);
  part.append(bytes(100, 7));
  EXPECT_EQ(part.size(), 400U);
  EXPECT_EQ(part.read(0, 300), bytes(300, 1));
  EXPECT_EQ(part.read(300, 100), bytes(100, 7));
  EXPECT_THROW((void)part.read(301, 100), text::OutputError);
  part.start_anew();
  EXPECT_EQ(part.size(), 0U);
  part.append(bytes(5, 9));
  EXPECT_EQ(part.read(0, 5), bytes(5, 9));
  part.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(LogPart, AFolderThatCannotBeMadeAndADiskThatIsFullAreNamed) {
  const test::Folder folder;
  (void)folder.write("file", "");
  EXPECT_THROW(LogPart{folder / "file/record.part"}, text::OutputError);
  if (std::filesystem::exists("/dev/full")) {
    LogPart full{"/dev/full"};
    try {
      full.append(bytes(10, 0));
      FAIL() << "a full disk took it";
    } catch (const text::OutputError& error) {
      EXPECT_EQ(std::string{error.what()}, "/dev/full: No space left on device");
    }
  }
}

TEST(Recording, CountsTheNumbersThatNeverCame) {
  Recording recording;
  for (const std::int64_t number : {10, 11, 14, 15, 20}) {
    EXPECT_TRUE(recording.add({.number = number}));
  }
  EXPECT_EQ(recording.lost_ticks(), 6U);
  EXPECT_EQ(recording.refused_ticks(), 0U);
}

TEST(Recording, RefusesWhatComesTwiceOrLate) {
  Recording recording;
  EXPECT_TRUE(recording.add({.number = 10}));
  EXPECT_FALSE(recording.add({.number = 10}));
  EXPECT_FALSE(recording.add({.number = 9}));
  EXPECT_TRUE(recording.add({.number = 11}));
  EXPECT_EQ(recording.ticks().size(), 2U);
  EXPECT_EQ(recording.refused_ticks(), 2U);
}

TEST(Recording, HoldsNoMoreThanItsBoundWhateverNumbersCome) {
  Recording recording{100};
  for (int i = 0; i < 1000; ++i) {
    recording.add({.number = i});
  }
  EXPECT_EQ(recording.ticks().size(), 100U);
  EXPECT_FALSE(recording.add({.number = std::numeric_limits<std::int64_t>::max()}));
  Recording far{100};
  EXPECT_TRUE(far.add({.number = std::numeric_limits<std::int64_t>::min()}));
  EXPECT_FALSE(far.add({.number = std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(far.lost_ticks(), 0U);
}

TEST(Recording, AnEmptyOneHasLostNothing) { EXPECT_EQ(Recording{}.lost_ticks(), 0U); }

using protocol::ArmReply;
using protocol::SelfTestState;

constexpr ArmReply running(std::optional<std::size_t> canard) {
  return {.self_test = SelfTestState::running, .canard = canard};
}

std::vector<std::size_t> said(const std::vector<ArmReply>& replies) {
  CanardUnderTest canard;
  std::vector<std::size_t> all;
  for (const ArmReply& reply : replies) {
    if (const auto news = canard.news(reply)) {
      all.push_back(*news);
    }
  }
  return all;
}

TEST(CanardUnderTest, EachIsSaidOnce) {
  EXPECT_EQ(said({running({}), running(0), running(0), running(1), running(1), running(2), running(3), running(3)}),
            (std::vector<std::size_t>{0, 1, 2, 3}));
}

// A second rocket rests for its self-test, or a stranger's frame comes, while a canard of the first one moves.
TEST(CanardUnderTest, AReplyThatNamesNoneIsOfNone) {
  const ArmReply passed{.self_test = SelfTestState::passed, .canard = 2};
  EXPECT_EQ(said({running(1), running({}), running(1), passed, running({}), running(2)}),
            (std::vector<std::size_t>{1, 2}));
}

}  // namespace

}  // namespace fantail::link
