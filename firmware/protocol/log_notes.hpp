// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/tick_record.hpp"
#include "core/time.hpp"

namespace fantail::protocol {

// What a flight log holds beside its ticks. The time of each stands in its frame's head and is that of a tick.

enum class LogEventKind : std::uint8_t {
  recording_began,      ///< number: of the flight, value: LogBegin
  recording_ended,      ///< value: LogEnd
  phase,                ///< value: core::Phase, detail: core::PhaseReason
  canard_verdict,       ///< index: canard 0 to 3, value: core::CanardVerdict
  gyro_state,           ///< value: core::SensorState
  accelerometer_state,  ///< likewise
  command_status,       ///< value: core::CommandStatus
  records_dropped,      ///< number: ticks that found no room in the queue, since the event before
  longest_tick,         ///< number: processor cycles of the longest tick so far, where the processor counts them
  board_faults,         ///< number: hal::BoardFaults::bits(), of which some came or went
  resumed,              ///< this record is the rest of a flight; value: ResumedAfter, number: resumes of it so far
  gyro_vote,            ///< value: core::GyroVote; of two gyros
  barometer_state,      ///< value: core::BarometerState
};
inline constexpr std::size_t log_event_kinds = 13;

/// Why a recording began.
enum class LogBegin : std::uint8_t {
  flight,        ///< the flight law saw a launch, or began control in the tunnel
  acceleration,  ///< it did not, but the specific force was beyond the plan's threshold
};
inline constexpr std::size_t log_begins = 2;

/// Why a recording ended.
enum class LogEnd : std::uint8_t {
  flight_over,      ///< Finished for long enough
  returned_to_pad,  ///< the flight law is in no flight: at rest again, or for a minute
  flash_full,
  flash_failed,
};
inline constexpr std::size_t log_ends = 4;

/// Nothing is resumed after any other reset.
enum class ResumedAfter : std::uint8_t { software, watchdog };
inline constexpr std::size_t resumed_after_causes = 2;

struct LogEvent {
  core::Microseconds time{};
  LogEventKind kind{};
  std::uint8_t value = 0;
  std::uint8_t detail = 0;
  std::uint8_t index = 0;
  std::uint32_t number = 0;
  friend bool operator==(const LogEvent&, const LogEvent&) = default;
};

/// Ten times a second.
struct LogHealth {
  core::Microseconds time{};
  std::array<core::CanardVerdict, core::canard_count> verdicts{};
  core::SensorState gyro = core::SensorState::failed;
  core::SensorState accelerometer = core::SensorState::failed;
  std::uint8_t bus_state = 0;  ///< as HealthReport
  std::uint16_t longest_tick_us = 0;
  std::uint16_t longest_queue = 0;  ///< ticks that waited for the flash, at most, since the record before
  std::uint32_t ticks_dropped = 0;  ///< since power-up
  std::uint32_t unsent = 0;         ///< frames of the bus, since power-up
  std::uint32_t bus_errors = 0;
};

inline constexpr std::size_t log_event_size = 8;
inline constexpr std::size_t log_health_size = 23;

[[nodiscard]] std::array<std::byte, log_event_size> pack(const LogEvent& event);
[[nodiscard]] std::array<std::byte, log_health_size> pack(const LogHealth& health);

/// Empty for another size and for a kind or a value that this version does not know.
[[nodiscard]] std::optional<LogEvent> unpack_event(core::Microseconds time, std::span<const std::byte> payload);
[[nodiscard]] std::optional<LogHealth> unpack_health(core::Microseconds time, std::span<const std::byte> payload);

/// A checkpoint's payload: two measurement times of the tick before (SampleTimes, 8 bytes each), then the state of the
/// flight law (state_block.hpp) before the first tick that follows.
inline constexpr std::size_t log_checkpoint_times_size = 16;

[[nodiscard]] std::string_view name(LogEventKind kind);
[[nodiscard]] std::string_view name(ResumedAfter cause);
[[nodiscard]] std::string_view name(LogEnd end);
[[nodiscard]] std::string_view name(LogBegin begin);

}  // namespace fantail::protocol
