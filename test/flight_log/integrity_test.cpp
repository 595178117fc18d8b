// SPDX-License-Identifier: MIT

#include "flight_log/integrity.hpp"

#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "flight_log/log_maker.hpp"
#include "flight_log/made_flight.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

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
  EXPECT_TRUE(says(integrity_text(file.flights[0]), "51 records, none missing; the recording ends early"));
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
                   "ends early: power was lost, the processor was reset, or the log was read before it ended"));
  flight.sensors = "simulated";
  EXPECT_TRUE(
      says(integrity_text(flight), "ends early: the simulation ended or reset the processor, or the file was cut off"));
  EXPECT_FALSE(says(integrity_text(flight), "power"));
  // The recorder goes on for half a minute after control, and a simulation for a second after apogee.
  flight.events.push_back(
      {.kind = protocol::LogEventKind::phase, .value = static_cast<std::uint8_t>(core::Phase::finished)});
  EXPECT_TRUE(says(integrity_text(flight), "; the recording ends after control, with the simulation (normal)"));
  EXPECT_FALSE(says(integrity_text(flight), "ends early"));
  flight.sensors = "ICM-42688-P, KX134-1211";
  EXPECT_TRUE(says(integrity_text(flight), "ends early: power was lost"));
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
  EXPECT_TRUE(says(replay_text(flight, regenerate(flight, *flight.plan)), "not possible: It contains no checkpoint"));
}

using core::Microseconds;

std::size_t records(const LogFile& file) {
  std::size_t sum = 0;
  for (const Flight& flight : file.flights) {
    sum += flight.records;
  }
  return sum;
}

// A hundred records: header, checkpoint, ticks and a health record.
MadeFlight short_flight() {
  MadeFlight made = make_flight();
  made.frame_ends.resize(100);
  made.bytes.resize(made.frame_ends.back());
  return made;
}

TEST(DamagedLog, CutAnywhereItKeepsEveryRecordBeforeTheCut) {
  const MadeFlight made = short_flight();
  for (std::size_t cut = 0; cut <= made.bytes.size(); ++cut) {
    const LogFile file = parse_log(std::span{made.bytes}.first(cut), "");
    const auto complete = std::ranges::upper_bound(made.frame_ends, cut) - made.frame_ends.begin();
    ASSERT_EQ(records(file), static_cast<std::size_t>(complete)) << "cut after " << cut << " bytes";
    const std::size_t rest = complete == 0 ? cut : cut - made.frame_ends[static_cast<std::size_t>(complete) - 1];
    ASSERT_LE(file.foreign_bytes, rest);  // an erased byte is not foreign
    ASSERT_EQ(file.cut_off_bytes, file.foreign_bytes);
  }
}

TEST(DamagedLog, EverySingleBitThatTurnsOverCostsItsOwnRecordAndIsNoticed) {
  const MadeFlight made = short_flight();
  std::vector<std::byte> bytes = made.bytes;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    const LogFile file = parse_log(bytes, "");
    ASSERT_EQ(records(file), made.frame_ends.size() - 1) << "bit " << bit;
    ASSERT_GT(file.foreign_bytes, 0U) << "bit " << bit;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
  }
}

TEST(DamagedLog, WhatIsMissingBetweenTwoRecordsIsAGapWithItsTimes) {
  const MadeFlight made = make_flight();
  std::vector<std::byte> bytes = made.bytes;
  // Records 1000 to 1009 are gone, without a trace in the bytes.
  bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(made.frame_ends[999]),
              bytes.begin() + static_cast<std::ptrdiff_t>(made.frame_ends[1009]));
  const LogFile file = parse_log(bytes, "");
  ASSERT_EQ(file.flights.size(), 1U);
  EXPECT_EQ(file.foreign_bytes, 0U);
  ASSERT_EQ(file.flights[0].gaps.size(), 1U);
  const Gap& gap = file.flights[0].gaps[0];
  EXPECT_EQ(gap.first_missing, 1000U);
  EXPECT_EQ(gap.count, 10U);
  EXPECT_LT(gap.before, gap.after);
  EXPECT_EQ(lost_records(file.flights[0]), 10U);
}

TEST(DamagedLog, ALengthThatCannotBeIsPassedOver) {
  LogMaker log;
  log.header(Microseconds{0}, some_header(), core::default_plan());
  const std::size_t records_before = records(parse_log(log.bytes(), ""));
  for (const int length : {4097, 65535}) {
    auto head = protocol::encode(protocol::LogFrameHead{.type = 3, .length = static_cast<std::uint16_t>(length)});
    log.append(head);
  }
  log.tick({.time = Microseconds{1'000}});
  const LogFile file = parse_log(log.bytes(), "");
  EXPECT_EQ(records(file), records_before + 1);
  EXPECT_EQ(file.foreign_bytes, 2 * protocol::log_head_size - 2) << "65535 looks like two bytes of erased flash";
}

TEST(DamagedLog, NoiseBetweenTheRecordsCostsNone) {
  const MadeFlight made = short_flight();
  std::mt19937 random{test::seed(20'261'121)};  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
  for (int run = 0; run < 50; ++run) {
    std::vector<std::byte> bytes;
    std::size_t begin = 0;
    for (const std::size_t end : made.frame_ends) {
      for (std::size_t n = random() % 40; n > 0; --n) {
        // The byte that begins a frame among them, so that false beginnings are common.
        bytes.push_back(random() % 4 == 0 ? protocol::log_sync : static_cast<std::byte>(random() % 256));
      }
      std::copy(made.bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                made.bytes.begin() + static_cast<std::ptrdiff_t>(end), std::back_inserter(bytes));
      begin = end;
    }
    ASSERT_EQ(records(parse_log(bytes, "")), made.frame_ends.size());
  }
}

TEST(DamagedLog, RandomBytesAreNoFlight) {
  std::mt19937 random{7};  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
  std::vector<std::byte> bytes(1 << 20);
  std::ranges::generate(bytes, [&] { return static_cast<std::byte>(random() % 256); });
  const LogFile file = parse_log(bytes, "");
  EXPECT_TRUE(file.flights.empty());
  const auto erased = static_cast<std::size_t>(std::ranges::count(bytes, std::byte{0xFF}));
  EXPECT_EQ(file.foreign_bytes, bytes.size() - erased);
}

}  // namespace

}  // namespace fantail::flight_log
