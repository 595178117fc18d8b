// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::flight_log {

struct LoggedTick {
  std::uint32_t sequence = 0;
  protocol::LogTick tick;
};

/// What the flight law remembered before the first tick whose sequence is higher.
struct Checkpoint {
  std::uint32_t sequence = 0;
  core::Microseconds time{};
  protocol::SampleTimes times;
  std::vector<std::byte> state;
};

/// A record as it lay in the file, with a payload that only its schema explains.
struct RawRecord {
  std::uint32_t sequence = 0;
  core::Microseconds time{};
  std::vector<std::byte> payload;
};

/// Where records are missing: those between two that are there, or those before the first (then `before` is `after`).
struct Gap {
  std::uint32_t first_missing = 0;
  std::uint32_t count = 0;
  core::Microseconds before{};  ///< time of the last record before it
  core::Microseconds after{};
  std::uint32_t dropped = 0;  ///< of them, those that the recorder itself left out, as it says behind them
};

/// One flight, as far as its log could be read.
struct Flight {
  std::size_t number = 1;  ///< in its file, counted from 1, as people call it

  // Of the first header that is intact; empty texts and zeros without one.
  bool has_header = false;
  std::uint16_t format_version = 0;
  std::uint32_t flight = 0;  ///< the place in the flash where it begins
  std::uint32_t power_up = 0;
  std::uint32_t state_layout = 0;
  float rate_scale_rad_s = 0.0F;
  float specific_force_scale_m_s2 = 0.0F;
  float accelerometer_scale_m_s2 = 0.0F;
  std::optional<float> second_rate_scale_rad_s;  ///< where two gyros flew
  std::string firmware_version;
  std::string git_hash;
  std::string vehicle;
  std::string sensors;
  std::string schema;
  std::vector<std::byte> plan_block;
  std::optional<core::FlightPlan> plan;  ///< empty when this program cannot read the block
  std::string plan_fault;                ///< why

  /// With the schema of this version; otherwise `foreign_ticks` holds the payloads and `ticks` is empty.
  std::vector<LoggedTick> ticks;
  std::vector<RawRecord> foreign_ticks;
  std::vector<Checkpoint> checkpoints;
  std::vector<protocol::LogEvent> events;
  std::vector<protocol::LogHealth> health;

  std::size_t records = 0;  ///< intact ones, of any type
  /// Of those: of a type, a size or a value that this version does not know.
  std::size_t unknown_records = 0;
  /// Sequences of the ticks among them: a replay cannot go past one.
  std::vector<std::uint32_t> unknown_ticks;
  std::vector<Gap> gaps;
  core::Microseconds first_time{};  ///< of the first and the last record
  core::Microseconds last_time{};
  bool goes_on = false;  ///< the processor was reset, and the next flight of the file is the rest of this one
};

/// How the record of the rest of a flight begins; empty where it is no such one.
[[nodiscard]] std::optional<protocol::LogEvent> resumed(const Flight& flight);

/// A file of flights: what a board's flash held, or one flight of it.
struct LogFile {
  std::string name;
  std::size_t bytes = 0;
  std::size_t foreign_bytes = 0;     ///< in no intact record, and not erased flash
  std::size_t foreign_places = 0;    ///< between two intact records, before the first or after the last
  std::size_t cut_off_bytes = 0;     ///< of the foreign ones, those of the last record of a flight, which was cut off
  std::vector<Flight> flights;       ///< in the order of the file; none when it holds no intact record
  std::size_t records_left_out = 0;  ///< what follows the flight number most_flights
};

/// Is it the rest of this one, which comes before it in its file?
[[nodiscard]] bool is_rest_of(const Flight& flight, const Flight& before);

/// Does the file hold one flight only, in one record or, after resets, in several?
[[nodiscard]] bool is_one_flight(const LogFile& file);

/// No log has so many flights; bytes that are made to look like it must not take all memory.
inline constexpr std::size_t most_flights = 1000;

/// Whatever bytes it is given: takes memory in proportion to them, and saves what can be saved.
[[nodiscard]] LogFile parse_log(std::span<const std::byte> bytes, std::string name);

/// A folder stands for the flight.ftl in it, or for its only .ftl. Throws text::Error: no_such_input; bad_data for a
/// file that holds no intact record at all (saying what it looks like instead); and as text::read_input() does.
[[nodiscard]] LogFile read_log_file(const std::filesystem::path& path);

/// What bytes without a single record are, as the end of a sentence: "a CSV file". People take the wrong file more
/// often than a log is damaged beyond reading.
[[nodiscard]] std::string looks_like(std::span<const std::byte> bytes);

}  // namespace fantail::flight_log
