// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "flight_log/log_maker.hpp"
#include "flight_log/made_flight.hpp"
#include "test.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;
using protocol::LogRecord;

void expect_equal(const protocol::LogTick& tick, const core::TickRecord& record) {
  EXPECT_EQ(tick.time, record.time);
  EXPECT_EQ(tick.phase, record.phase);
  EXPECT_EQ(tick.command, record.command);
}

TEST(ParseLog, AnIntactFlightComesBackWhole) {
  const MadeFlight made = make_flight();
  const LogFile file = parse_log(made.bytes, "a.ftl");
  EXPECT_EQ(file.name, "a.ftl");
  EXPECT_EQ(file.bytes, made.bytes.size());
  EXPECT_EQ(file.foreign_bytes, 0U);
  EXPECT_EQ(file.cut_off_bytes, 0U);
  ASSERT_EQ(file.flights.size(), 1U);
  const Flight& flight = file.flights[0];
  EXPECT_EQ(flight.records, made.frame_ends.size());
  EXPECT_EQ(flight.unknown_records, 0U);
  EXPECT_TRUE(flight.gaps.empty());
  EXPECT_TRUE(flight.foreign_ticks.empty());
  ASSERT_EQ(flight.ticks.size(), 3000U) << "three seconds at 1 kHz";
  for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
    expect_equal(flight.ticks[i].tick, made.records[i]);
  }
  EXPECT_EQ(flight.first_time, Microseconds{5'500'000});
  EXPECT_EQ(flight.last_time, Microseconds{8'499'000});
  EXPECT_EQ(flight.checkpoints.size(), 6U) << "every half second";
  EXPECT_EQ(flight.health.size(), 30U) << "every tenth of a second";
  ASSERT_EQ(flight.events.size(), 3U) << "launched, controlling, the end";
  EXPECT_EQ(flight.events[0].value, static_cast<std::uint8_t>(core::Phase::launched));
  EXPECT_EQ(flight.events[1].value, static_cast<std::uint8_t>(core::Phase::controlling));
  EXPECT_EQ(flight.events[2].kind, protocol::LogEventKind::recording_ended);
}

TEST(ParseLog, TheHeaderSaysWhatFlew) {
  const LogFile file = parse_log(make_flight().bytes, "a.ftl");
  const Flight& flight = file.flights.at(0);
  EXPECT_TRUE(flight.has_header);
  EXPECT_EQ(flight.format_version, 1);
  EXPECT_EQ(flight.flight, 1U);
  EXPECT_EQ(flight.power_up, 7U);
  EXPECT_EQ(flight.rate_scale_rad_s, 0.001F);
  EXPECT_EQ(flight.specific_force_scale_m_s2, 0.00980665F);
  EXPECT_EQ(flight.accelerometer_scale_m_s2, 0.0980665F);
  EXPECT_EQ(flight.firmware_version, "0.1.0");
  EXPECT_EQ(flight.git_hash, "0123456789abcdef");
  EXPECT_EQ(flight.vehicle, "paper dart");
  EXPECT_EQ(flight.sensors, "imu x, accelerometer y");
  EXPECT_EQ(flight.schema, protocol::log_schema());
  ASSERT_TRUE(flight.plan.has_value());
  EXPECT_EQ(protocol::plan_crc(*flight.plan), protocol::plan_crc(core::default_plan()));
}

TEST(ParseLog, ASampleThatCameBeforeKeepsItsTimeHoweverOld) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(), core::default_plan());
  core::Autopilot law{core::default_plan()};
  log.set_times({.imu = Microseconds{1'000}, .accelerometer = Microseconds{2'000}});
  log.checkpoint(Microseconds{900'000}, law);
  log.tick({.time = Microseconds{900'000}, .imu_time = Microseconds{1'000}, .accelerometer_time = Microseconds{2'000}});
  log.tick(
      {.time = Microseconds{901'000}, .imu_time = Microseconds{900'500}, .accelerometer_time = Microseconds{2'000}});
  log.tick(
      {.time = Microseconds{990'000}, .imu_time = Microseconds{900'500}, .accelerometer_time = Microseconds{2'000}});
  const LogFile file = parse_log(log.bytes(), "");
  const auto& ticks = file.flights.at(0).ticks;
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_EQ(ticks[0].tick.imu_time, Microseconds{1'000});
  EXPECT_EQ(ticks[1].tick.imu_time, Microseconds{900'500});
  EXPECT_EQ(ticks[2].tick.imu_time, Microseconds{900'500});
  EXPECT_EQ(ticks[2].tick.accelerometer_time, Microseconds{2'000});
}

TEST(ParseLog, FlightsBehindEachOtherAreToldApart) {
  std::vector<std::byte> bytes = make_flight({.flight = 1}).bytes;
  const MadeFlight second = make_flight({.flight = 2, .length = Microseconds{1'000'000}});
  bytes.insert(bytes.end(), 1000, std::byte{0xFF});  // the rest of a page of flash
  bytes.insert(bytes.end(), second.bytes.begin(), second.bytes.end());
  const LogFile file = parse_log(bytes, "both");
  ASSERT_EQ(file.flights.size(), 2U);
  EXPECT_EQ(file.flights[0].ticks.size(), 3000U);
  EXPECT_EQ(file.flights[0].flight, 1U);
  EXPECT_EQ(file.flights[1].ticks.size(), 1000U);
  EXPECT_EQ(file.flights[1].flight, 2U);
  EXPECT_EQ(file.foreign_bytes, 0U) << "erased flash is nothing foreign";
}

TEST(ParseLog, ThePlacesWhereSomethingForeignLiesAreCounted) {
  const std::vector<std::byte> flight = make_flight().bytes;
  std::vector<std::byte> bytes(10, std::byte{0x00});
  std::ranges::copy(flight, std::back_inserter(bytes));
  bytes.insert(bytes.end(), 7, protocol::log_sync);
  std::ranges::copy(flight, std::back_inserter(bytes));
  const LogFile file = parse_log(bytes, "both");
  EXPECT_EQ(file.foreign_bytes, 17U);
  EXPECT_EQ(file.foreign_places, 2U);
  EXPECT_EQ(file.cut_off_bytes, 0U);
}

TEST(ParseLog, TheSameFlightTwiceIsTwoFlights) {
  std::vector<std::byte> bytes = make_flight().bytes;
  const std::vector<std::byte> once = bytes;
  bytes.insert(bytes.end(), once.begin(), once.end());
  const LogFile file = parse_log(bytes, "twice");
  ASSERT_EQ(file.flights.size(), 2U);
  EXPECT_EQ(file.flights[0].ticks.size(), file.flights[1].ticks.size());
  EXPECT_TRUE(file.flights[0].gaps.empty());
  EXPECT_TRUE(file.flights[1].gaps.empty());
}

TEST(ParseLog, AnotherHeaderBeginsAnotherFlightEvenWhenItsSequenceGoesOn) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(1), core::default_plan());
  log.tick({.time = Microseconds{1'000}});
  log.header(Microseconds{2'000}, some_header(1), core::default_plan());
  log.tick({.time = Microseconds{3'000}});
  log.header(Microseconds{4'000}, some_header(2), core::default_plan());
  log.tick({.time = Microseconds{5'000}});
  const LogFile file = parse_log(log.bytes(), "");
  ASSERT_EQ(file.flights.size(), 2U);
  EXPECT_EQ(file.flights[0].ticks.size(), 2U);
  EXPECT_EQ(file.flights[1].ticks.size(), 1U);
}

TEST(ParseLog, AClockThatBeganAgainBeginsAnotherFlight) {
  LogMaker log;
  log.header(Microseconds{60'000'000}, some_header(1), core::default_plan());
  log.tick({.time = Microseconds{60'001'000}});
  log.tick({.time = Microseconds{59'800'000}});  // from the ring: half a second is nothing
  log.tick({.time = Microseconds{3'000}});
  EXPECT_EQ(parse_log(log.bytes(), "").flights.size(), 2U);
}

TEST(ParseLog, ARecordOfAnUnknownTypeIsCountedAndPassedOver) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(), core::default_plan());
  log.record(static_cast<LogRecord>(200), Microseconds{1'000}, std::array<std::byte, 30>{});
  log.tick({.time = Microseconds{2'000}});
  const LogFile file = parse_log(log.bytes(), "");
  const Flight& flight = file.flights.at(0);
  EXPECT_EQ(flight.records, 3U);
  EXPECT_EQ(flight.unknown_records, 1U);
  EXPECT_EQ(flight.ticks.size(), 1U);
  EXPECT_TRUE(flight.gaps.empty());
}

TEST(ParseLog, ATickThatCannotBeIsCountedAndItsPlaceKept) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(), core::default_plan());
  log.record(LogRecord::tick, Microseconds{1'000}, std::array<std::byte, 7>{});
  protocol::SampleTimes times;
  protocol::PackedTick payload = protocol::pack({.time = Microseconds{2'000}}, times);
  payload[0] |= std::byte{7};  // there is no such phase
  log.record(LogRecord::tick, Microseconds{2'000}, payload);
  const LogFile file = parse_log(log.bytes(), "");
  EXPECT_EQ(file.flights.at(0).unknown_records, 2U);
  EXPECT_EQ(file.flights.at(0).unknown_ticks, (std::vector<std::uint32_t>{1, 2}));
}

TEST(ParseLog, TicksOfAnotherVersionAreKeptAsTheyLay) {
  protocol::LogHeader header = some_header();
  header.format_version = 9;
  header.schema = "tick 3\n0 u8 phase\n1 u16 mood furlong\n";
  LogMaker log;
  log.header(Microseconds{0}, header, core::default_plan());
  log.record(LogRecord::tick, Microseconds{1'000}, std::array{std::byte{4}, std::byte{0x39}, std::byte{0x05}});
  const LogFile file = parse_log(log.bytes(), "");
  const Flight& flight = file.flights.at(0);
  EXPECT_TRUE(flight.ticks.empty());
  ASSERT_EQ(flight.foreign_ticks.size(), 1U);
  EXPECT_EQ(flight.foreign_ticks[0].time, Microseconds{1'000});
  EXPECT_EQ(flight.foreign_ticks[0].payload.size(), 3U);
  EXPECT_EQ(flight.schema, header.schema);
  EXPECT_EQ(flight.unknown_records, 0U);
}

TEST(ParseLog, WithoutAHeaderTicksAreReadAsThoseOfThisVersion) {
  LogMaker log;
  log.skip_to(5);
  log.tick({.time = Microseconds{1'000}});
  log.tick({.time = Microseconds{2'000}});
  const LogFile file = parse_log(log.bytes(), "");
  const Flight& flight = file.flights.at(0);
  EXPECT_FALSE(flight.has_header);
  EXPECT_FALSE(flight.plan.has_value());
  EXPECT_EQ(flight.ticks.size(), 2U);
  ASSERT_EQ(flight.gaps.size(), 1U) << "the five before it";
  EXPECT_EQ(flight.gaps[0].first_missing, 0U);
  EXPECT_EQ(flight.gaps[0].count, 5U);
  EXPECT_EQ(flight.gaps[0].before, flight.gaps[0].after);
}

TEST(ParseLog, TicksThatComeBeforeTheFirstIntactHeaderAreReadByIt) {
  protocol::LogHeader header = some_header();
  header.schema = "tick 1\n0 u8 x\n";
  LogMaker log;
  log.skip_to(1);
  log.record(LogRecord::tick, Microseconds{1'000}, std::array{std::byte{4}});
  log.header(Microseconds{2'000}, header, core::default_plan());
  const LogFile file = parse_log(log.bytes(), "");
  EXPECT_EQ(file.flights.at(0).foreign_ticks.size(), 1U);
  EXPECT_EQ(file.flights.at(0).unknown_records, 0U);
}

TEST(ParseLog, APlanThatThisProgramCannotReadIsSaid) {
  protocol::LogHeader header = some_header();
  header.plan_block = std::as_bytes(std::span{"FTPL and no more of it"});
  const auto fixed = protocol::encode(header);
  std::vector<std::byte> payload{fixed.begin(), fixed.end()};
  std::ranges::copy(header.plan_block, std::back_inserter(payload));
  LogMaker log;
  log.record(LogRecord::header, Microseconds{0}, payload);
  const LogFile file = parse_log(log.bytes(), "");
  const Flight& flight = file.flights.at(0);
  EXPECT_TRUE(flight.has_header);
  EXPECT_FALSE(flight.plan.has_value());
  EXPECT_FALSE(flight.plan_fault.empty());
}

TEST(ParseLog, BytesThatPretendToBeManyFlightsAreRefusedAfterTheThousandth) {
  LogMaker log;
  for (std::size_t i = 0; i < most_flights + 500; ++i) {
    log.skip_to(0);
    log.tick({.time = Microseconds{1'000}});
  }
  const LogFile file = parse_log(log.bytes(), "");
  EXPECT_EQ(file.flights.size(), most_flights);
  EXPECT_EQ(file.records_left_out, 500U);
}

TEST(ParseLog, WhatTheRecorderLeftOutIsNoDamage) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(), core::default_plan());
  log.tick({.time = Microseconds{1'000}});
  log.skip_to(log.sequence() + 5);
  log.event({.time = Microseconds{7'000}, .kind = protocol::LogEventKind::records_dropped, .number = 4});
  log.tick({.time = Microseconds{7'000}});
  log.skip_to(log.sequence() + 3);
  log.tick({.time = Microseconds{11'000}});
  log.event({.time = Microseconds{11'000}, .kind = protocol::LogEventKind::records_dropped, .number = 3});
  const LogFile file = parse_log(log.bytes(), "");
  const auto& gaps = file.flights.at(0).gaps;
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].count, 5U);
  EXPECT_EQ(gaps[0].dropped, 4U);
  EXPECT_EQ(gaps[1].count, 3U);
  EXPECT_EQ(gaps[1].dropped, 0U) << "what is said elsewhere is said of another gap";
}

TEST(ParseLog, NothingIsNoFlight) { EXPECT_TRUE(parse_log({}, "empty").flights.empty()); }

}  // namespace
}  // namespace fantail::flight_log
