// SPDX-License-Identifier: MIT
// Any bytes as a flight log: what is intact in them is read, replayed and shown, and nothing else may happen.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "flight_log/event_text.hpp"
#include "flight_log/flight_figures.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/schema.hpp"
#include "flight_log/to_report.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_schema.hpp"

namespace {

using namespace fantail;

void require(bool promise) {
  if (!promise) {
    std::abort();
  }
}

bool is_sentence(const std::string& text) {
  return !text.empty() && text.size() < 4000 &&
         std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

// A checksum lets one mutation in four thousand million through. Here every frame that lies where it could is given
// the right one, so that what lies behind the checksum is tried too.
void seal_frames(std::span<std::byte> bytes) {
  std::size_t at = 0;
  while (at + protocol::log_frame_overhead <= bytes.size()) {
    const auto length = static_cast<std::size_t>(protocol::get<2>(bytes, at + 2));
    const std::size_t end = at + protocol::log_head_size + length;
    if (bytes[at] != protocol::log_sync || length > protocol::largest_log_payload || end + 4 > bytes.size()) {
      at += 1;
      continue;
    }
    protocol::put<4>(bytes, end, protocol::crc32c(bytes.subspan(at, end - at)));
    at = end + 4;
  }
}

void check_schema(const flight_log::Flight& flight) {
  const auto schema = flight_log::parse_schema(flight.schema);
  const auto* tick = flight_log::find_record(schema, "tick");
  for (const flight_log::RawRecord& record : flight.foreign_ticks) {
    for (std::size_t i = 0; tick != nullptr && i < tick->fields.size(); ++i) {
      (void)flight_log::value(tick->fields[i], record.payload);
    }
  }
}

void check_order(const flight_log::Flight& flight) {
  for (std::size_t i = 1; i < flight.ticks.size(); ++i) {
    require(flight.ticks[i].sequence > flight.ticks[i - 1].sequence);
  }
  for (std::size_t i = 1; i < flight.gaps.size(); ++i) {
    require(flight.gaps[i].first_missing > flight.gaps[i - 1].first_missing);
  }
  for (const flight_log::Gap& gap : flight.gaps) {
    require(gap.count > 0 && gap.dropped <= gap.count);
  }
  require(flight.ticks.size() + flight.foreign_ticks.size() + flight.checkpoints.size() + flight.events.size() +
              flight.health.size() + flight.unknown_records <=
          flight.records);
  require(flight.ticks.empty() || flight.foreign_ticks.empty());
}

void check_replay(const flight_log::Flight& flight) {
  if (!flight.plan) {
    (void)flight_log::to_report(flight, {});
    return;
  }
  const flight_log::Regeneration replay = flight_log::regenerate(flight, *flight.plan);
  require(replay.records.size() == flight.ticks.size());
  require(replay.compared + replay.unreachable == flight.ticks.size());
  require(replay.compared > 0 || !replay.obstacle.empty());
  require(replay.first_difference.has_value() == (replay.differing > 0));
  require(!replay.first_difference || !replay.first_difference->field.empty());
  require(is_sentence(flight_log::replay_text(flight, replay)));
  const flight::Flight report = flight_log::to_report(flight, replay);
  require(report.rows.size() == replay.compared);
  require(std::ranges::all_of(report.notes, is_sentence));
}

void check_flight(const flight_log::Flight& flight) {
  check_order(flight);
  check_schema(flight);
  check_replay(flight);
  require(is_sentence(flight_log::integrity_text(flight)));
  for (const protocol::LogEvent& event : flight.events) {
    require(is_sentence(flight_log::event_text(event, flight.first_time)));
  }
  const auto loop = flight_log::loop_times(flight);
  require(!loop || (loop->mean_us <= loop->longest_us && loop->p99_us <= loop->longest_us));
  (void)flight_log::health_figures(flight);
}

void check_log(std::span<const std::byte> bytes) {
  const flight_log::LogFile file = flight_log::parse_log(bytes, "flight.ftl");
  require(file.bytes == bytes.size() && file.foreign_bytes <= bytes.size());
  require(file.cut_off_bytes <= file.foreign_bytes && file.foreign_places <= file.foreign_bytes);
  std::size_t records = file.records_left_out;
  for (const flight_log::Flight& flight : file.flights) {
    require(flight.records > 0);
    records += flight.records;
    check_flight(flight);
  }
  require(records * protocol::log_frame_overhead + file.foreign_bytes <= bytes.size());
  require(is_sentence(flight_log::looks_like(bytes)));
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const auto given = std::as_bytes(std::span{data, size});
  std::vector<std::byte> bytes{given.begin() + 1, given.end()};
  if ((data[0] & 1U) != 0) {
    seal_frames(bytes);
  }
  check_log(bytes);
  return 0;
}
