// SPDX-License-Identifier: MIT
#include "protocol/log_notes.hpp"

#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

// How many values an event of this kind may have; 1 where the value says nothing.
std::size_t values(LogEventKind kind) {
  switch (kind) {
    case LogEventKind::recording_ended: return log_ends;
    case LogEventKind::phase: return core::phases;
    case LogEventKind::canard_verdict: return core::canard_verdicts;
    case LogEventKind::gyro_state:
    case LogEventKind::accelerometer_state: return core::sensor_states;
    case LogEventKind::command_status: return core::command_statuses;
    case LogEventKind::resumed: return resumed_after_causes;
    case LogEventKind::gyro_vote: return core::gyro_votes;
    case LogEventKind::barometer_state: return core::barometer_states;
    case LogEventKind::recording_began: return log_begins;
    case LogEventKind::records_dropped:
    case LogEventKind::longest_tick:
    case LogEventKind::board_faults: break;
  }
  return 1;
}

}  // namespace

std::array<std::byte, log_event_size> pack(const LogEvent& event) {
  std::array<std::byte, log_event_size> out{};
  put<1>(out, 0, static_cast<std::uint8_t>(event.kind));
  put<1>(out, 1, event.value);
  put<1>(out, 2, event.detail);
  put<1>(out, 3, event.index);
  put<4>(out, 4, event.number);
  return out;
}

std::optional<LogEvent> unpack_event(core::Microseconds time, std::span<const std::byte> payload) {
  if (payload.size() != log_event_size || get<1>(payload, 0) >= log_event_kinds) {
    return std::nullopt;
  }
  const LogEvent event{.time = time,
                       .kind = static_cast<LogEventKind>(get<1>(payload, 0)),
                       .value = static_cast<std::uint8_t>(get<1>(payload, 1)),
                       .detail = static_cast<std::uint8_t>(get<1>(payload, 2)),
                       .index = static_cast<std::uint8_t>(get<1>(payload, 3)),
                       .number = static_cast<std::uint32_t>(get<4>(payload, 4))};
  const std::size_t details = event.kind == LogEventKind::phase ? core::phase_reasons : 1;
  const std::size_t indices = event.kind == LogEventKind::canard_verdict ? core::canard_count : 1;
  if (event.value >= values(event.kind) || event.detail >= details || event.index >= indices) {
    return std::nullopt;
  }
  return event;
}

std::array<std::byte, log_health_size> pack(const LogHealth& health) {
  std::array<std::byte, log_health_size> out{};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    put<1>(out, i, static_cast<std::uint8_t>(health.verdicts[i]));
  }
  put<1>(out, 4, static_cast<std::uint8_t>(health.gyro));
  put<1>(out, 5, static_cast<std::uint8_t>(health.accelerometer));
  put<1>(out, 6, health.bus_state);
  put<2>(out, 7, health.longest_tick_us);
  put<2>(out, 9, health.longest_queue);
  put<4>(out, 11, health.ticks_dropped);
  put<4>(out, 15, health.unsent);
  put<4>(out, 19, health.bus_errors);
  return out;
}

std::optional<LogHealth> unpack_health(core::Microseconds time, std::span<const std::byte> payload) {
  if (payload.size() != log_health_size) {
    return std::nullopt;
  }
  LogHealth health{.time = time};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (get<1>(payload, i) >= core::canard_verdicts) {
      return std::nullopt;
    }
    health.verdicts[i] = static_cast<core::CanardVerdict>(get<1>(payload, i));
  }
  if (get<1>(payload, 4) >= core::sensor_states || get<1>(payload, 5) >= core::sensor_states) {
    return std::nullopt;
  }
  health.gyro = static_cast<core::SensorState>(get<1>(payload, 4));
  health.accelerometer = static_cast<core::SensorState>(get<1>(payload, 5));
  health.bus_state = static_cast<std::uint8_t>(get<1>(payload, 6));
  health.longest_tick_us = static_cast<std::uint16_t>(get<2>(payload, 7));
  health.longest_queue = static_cast<std::uint16_t>(get<2>(payload, 9));
  health.ticks_dropped = static_cast<std::uint32_t>(get<4>(payload, 11));
  health.unsent = static_cast<std::uint32_t>(get<4>(payload, 15));
  health.bus_errors = static_cast<std::uint32_t>(get<4>(payload, 19));
  return health;
}

std::string_view name(LogEventKind kind) {
  switch (kind) {
    case LogEventKind::recording_began: return "recording_began";
    case LogEventKind::recording_ended: return "recording_ended";
    case LogEventKind::phase: return "phase";
    case LogEventKind::canard_verdict: return "canard_verdict";
    case LogEventKind::gyro_state: return "gyro_state";
    case LogEventKind::accelerometer_state: return "accelerometer_state";
    case LogEventKind::command_status: return "command_status";
    case LogEventKind::records_dropped: return "records_dropped";
    case LogEventKind::longest_tick: return "longest_tick";
    case LogEventKind::board_faults: return "board_faults";
    case LogEventKind::resumed: return "resumed";
    case LogEventKind::gyro_vote: return "gyro_vote";
    case LogEventKind::barometer_state: return "barometer_state";
  }
  return "unknown";
}

std::string_view name(LogBegin begin) {
  switch (begin) {
    case LogBegin::flight: return "flight";
    case LogBegin::acceleration: return "acceleration";
  }
  return "unknown";
}

std::string_view name(LogEnd end) {
  switch (end) {
    case LogEnd::flight_over: return "flight_over";
    case LogEnd::returned_to_pad: return "returned_to_pad";
    case LogEnd::flash_full: return "flash_full";
    case LogEnd::flash_failed: return "flash_failed";
  }
  return "unknown";
}

std::string_view name(ResumedAfter cause) {
  switch (cause) {
    case ResumedAfter::software: return "software";
    case ResumedAfter::watchdog: return "watchdog";
  }
  return "unknown";
}

}  // namespace fantail::protocol
