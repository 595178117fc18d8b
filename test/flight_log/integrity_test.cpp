// SPDX-License-Identifier: MIT
#include "flight_log/integrity.hpp"

#include <algorithm>
#include <iterator>

#include <gtest/gtest.h>

#include "flight_log/made_flight.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

TEST(Integrity, AWholeLogIsIntact) {
  const MadeFlight made = make_flight();
  const LogFile file = parse_log(made.bytes, "");
  EXPECT_TRUE(intact(file));
  EXPECT_EQ(integrity_text(file.flights[0]),
            "intact: " + std::to_string(made.frame_ends.size()) + " records, none missing");
  EXPECT_EQ(foreign_bytes_text(file), "");
}

TEST(Integrity, ALogThatWasCutOffIsIntactAsFarAsItGoesAndSaysSo) {
  const MadeFlight made = make_flight();
  const LogFile file = parse_log(std::span{made.bytes}.first(made.frame_ends[50] + 20), "");
  EXPECT_TRUE(intact(file));
  EXPECT_FALSE(has_end(file.flights[0]));
  EXPECT_TRUE(says(integrity_text(file.flights[0]), "51 records, none missing; the recording breaks off"));
  EXPECT_TRUE(says(foreign_bytes_text(file), "at the end of a flight, where its last record was cut off"));
}

TEST(Integrity, DamageOfMoreThanTheLastRecordIsNoCutOff) {
  MadeFlight made = make_flight({.ended = false});
  const std::size_t from = made.frame_ends.rbegin()[20] + 20;
  std::fill(made.bytes.begin() + static_cast<std::ptrdiff_t>(from), made.bytes.end(), std::byte{0});
  const LogFile file = parse_log(made.bytes, "");
  EXPECT_FALSE(intact(file));
  EXPECT_FALSE(says(foreign_bytes_text(file), "cut off"));
}

// Each was switched off while it wrote.
TEST(Integrity, ARecordThatWasCutOffBeforeAnotherFlightIsNoDamage) {
  const MadeFlight made = make_flight();
  std::vector<std::byte> bytes{made.bytes.begin(),
                               made.bytes.begin() + static_cast<std::ptrdiff_t>(made.frame_ends[50] + 20)};
  bytes.resize(8'192, std::byte{0xFF});
  std::ranges::copy(make_flight({.flight = 2}).bytes, std::back_inserter(bytes));
  const LogFile file = parse_log(bytes, "");
  ASSERT_EQ(file.flights.size(), 2U);
  EXPECT_TRUE(intact(file));
}

// Of a simulated rocket nobody cuts the power.
TEST(Integrity, WhyARecordingBreaksOffDependsOnWhatRecordedIt) {
  Flight flight;
  flight.has_header = true;
  flight.sensors = "ICM-42688-P, KX134-1211";
  EXPECT_TRUE(says(integrity_text(flight),
                   "breaks off: power was lost, the processor was reset, or the log was read before it ended"));
  flight.sensors = "simulated";
  EXPECT_TRUE(
      says(integrity_text(flight), "breaks off: the simulation ended or reset the processor, or the file was cut off"));
  EXPECT_FALSE(says(integrity_text(flight), "power"));
  // The recorder goes on for half a minute after control, and a simulation for a second after apogee.
  flight.events.push_back(
      {.kind = protocol::LogEventKind::phase, .value = static_cast<std::uint8_t>(core::Phase::finished)});
  EXPECT_TRUE(says(integrity_text(flight), "; the recording ends after control, as the simulation does (normal)"));
  EXPECT_FALSE(says(integrity_text(flight), "breaks off"));
  flight.sensors = "ICM-42688-P, KX134-1211";
  EXPECT_TRUE(says(integrity_text(flight), "breaks off: power was lost"));
}

TEST(Integrity, ATurnedBitIsDamageAndCountedInRecordsGapsAndBytes) {
  MadeFlight made = make_flight();
  made.bytes[made.frame_ends[50] + 20] ^= std::byte{1};
  made.bytes[made.frame_ends[60] + 20] ^= std::byte{1};
  const LogFile file = parse_log(made.bytes, "");
  EXPECT_FALSE(intact(file));
  EXPECT_TRUE(says(integrity_text(file.flights[0]), "damaged: 2 records lost in 2 gaps"));
  EXPECT_TRUE(says(foreign_bytes_text(file), "in 2 places"));
}

TEST(Integrity, WithoutAHeaderALogIsDamaged) {
  Flight flight;
  flight.records = 1;
  EXPECT_FALSE(intact(flight));
  EXPECT_TRUE(says(integrity_text(flight), "1 record, none missing; no header"));
}

TEST(Integrity, RecordsThatWereNeverWrittenAreAddedUp) {
  Flight flight;
  flight.events = {{.kind = protocol::LogEventKind::records_dropped, .number = 3},
                   {.kind = protocol::LogEventKind::recording_began, .number = 100},
                   {.kind = protocol::LogEventKind::records_dropped, .number = 4}};
  EXPECT_EQ(dropped_records(flight), 7U);
}

TEST(Integrity, TheReplayIsSaidInWords) {
  LogFile file = parse_log(make_flight().bytes, "");
  Flight& flight = file.flights[0];
  EXPECT_EQ(replay_text(flight, regenerate(flight, *flight.plan)),
            "equal: 3000 ticks replayed, every output byte as recorded");
  flight.ticks[700].tick.command = core::Angle::from_radians(0.25F);
  // The 701st tick is 0.7 s after the first, at 5.5 s.
  EXPECT_TRUE(says(replay_text(flight, regenerate(flight, *flight.plan)),
                   "differs: 1 tick of 3000; first at 6.200000 s (tick 700): command was 0.25 rad, replayed"));
  flight.checkpoints.clear();
  EXPECT_TRUE(says(replay_text(flight, regenerate(flight, *flight.plan)), "not possible: It holds no checkpoint"));
}

}  // namespace
}  // namespace fantail::flight_log
