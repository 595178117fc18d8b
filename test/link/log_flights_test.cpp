// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "link/log_download.hpp"
#include "link/made_record.hpp"
#include "protocol/log_notes.hpp"

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

}  // namespace
}  // namespace fantail::link
