// SPDX-License-Identifier: MIT
#include "flight_log/integrity.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "text/number.hpp"

namespace fantail::flight_log {

using text::counted;

std::uint64_t lost_records(const Flight& flight) {
  std::uint64_t lost = 0;
  for (const Gap& gap : flight.gaps) {
    lost += gap.count - gap.dropped;
  }
  return lost;
}

std::uint64_t dropped_records(const Flight& flight) {
  std::uint64_t dropped = 0;
  for (const protocol::LogEvent& event : flight.events) {
    dropped += event.kind == protocol::LogEventKind::records_dropped ? event.number : 0;
  }
  return dropped;
}

bool has_end(const Flight& flight) {
  return std::ranges::any_of(flight.events,
                             [](const auto& e) { return e.kind == protocol::LogEventKind::recording_ended; });
}

bool is_simulated(const Flight& flight) { return flight.sensors.starts_with("simulated"); }

std::string end_text(const Flight& flight) {
  if (flight.goes_on) {
    return fmt::format("the recording ends early: the processor was reset, and flight {} is the rest",
                       flight.number + 1);
  }
  if (!is_simulated(flight)) {
    return "the recording ends early: power was lost, the processor was reset, or the log was read before it ended";
  }
  const bool was_over = std::ranges::any_of(flight.events, [](const protocol::LogEvent& event) {
    return event.kind == protocol::LogEventKind::phase &&
           event.value == static_cast<std::uint8_t>(core::Phase::finished);
  });
  return was_over ? "the recording ends after control, with the simulation (normal)"
                  : "the recording ends early: the simulation ended or reset the processor, or the file was cut off";
}

bool intact(const Flight& flight) { return lost_records(flight) == 0 && flight.has_header; }

bool intact(const LogFile& file) {
  return !file.flights.empty() && file.foreign_bytes == file.cut_off_bytes && file.records_left_out == 0 &&
         std::ranges::all_of(file.flights, [](const Flight& flight) { return intact(flight); });
}

std::string integrity_text(const Flight& flight) {
  std::string text;
  if (const std::uint64_t lost = lost_records(flight); lost > 0) {
    const auto gaps = std::ranges::count_if(flight.gaps, [](const Gap& gap) { return gap.dropped < gap.count; });
    text = fmt::format("damaged: {} lost in {}, {} left", counted(lost, "record"),
                       counted(static_cast<std::uint64_t>(gaps), "gap"), flight.records);
  } else {
    text = fmt::format("{}: {}, none missing", flight.has_header ? "intact" : "damaged",
                       counted(flight.records, "record"));
  }
  if (!flight.has_header) {
    text += "; no header, so the plan and the sensor scales are unknown";
  }
  if (const std::uint64_t dropped = dropped_records(flight); dropped > 0) {
    text += fmt::format("; {} never written, because the flash was too slow", counted(dropped, "record"));
  }
  if (!has_end(flight)) {
    text += "; " + end_text(flight);
  }
  if (flight.unknown_records > 0) {
    text += fmt::format("; {} of a type unknown to this version", counted(flight.unknown_records, "record"));
  }
  return text;
}

std::string foreign_bytes_text(const LogFile& file) {
  if (file.foreign_bytes == 0) {
    return {};
  }
  std::string text = fmt::format("{} in {} {} outside the intact records", counted(file.foreign_bytes, "byte"),
                                 counted(file.foreign_places, "place"), file.foreign_bytes == 1 ? "lies" : "lie");
  if (file.cut_off_bytes > 0) {
    text += fmt::format("; {} of them at the end of a flight, where its last record was cut off", file.cut_off_bytes);
  }
  return text;
}

std::string replay_text(const Flight& flight, const Regeneration& regeneration) {
  if (!regeneration.obstacle.empty()) {
    return "not possible: " + regeneration.obstacle;
  }
  std::string text;
  if (const auto& difference = regeneration.first_difference) {
    const LoggedTick& tick = flight.ticks[difference->tick];
    text = fmt::format("differs: {} of {}; first at {:.6f} s (tick {}): {} was {}, replayed {}",
                       counted(regeneration.differing, "tick"), regeneration.compared,
                       1e-6 * static_cast<double>(tick.tick.time.count()), difference->tick, difference->field,
                       difference->recorded, difference->replayed);
  } else {
    text = fmt::format("equal: {} replayed, every output byte as recorded", counted(regeneration.compared, "tick"));
  }
  if (regeneration.unreachable > 0) {
    text += fmt::format("; {} after a gap, before the next checkpoint, could not be replayed",
                        counted(regeneration.unreachable, "tick"));
  }
  return text;
}

}  // namespace fantail::flight_log
