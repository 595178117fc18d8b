// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/angle.hpp"
#include "core/flight_phase.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "core/time.hpp"

namespace fantail::protocol {

/// What a device said about its reading (as the hardware layer has it).
enum class DeviceStatus : std::uint8_t { ok, error, no_reading };

/// Where two gyros fly. What else the second IMU measures does not come into the flight law, and the slowest flash has
/// no room for it.
struct LogSecondGyro {
  core::Microseconds time{};
  std::array<std::int16_t, 3> rate_counts{};
  DeviceStatus status = DeviceStatus::no_reading;
};

/// A new reading of a barometer: most ticks have none. What a barometer says that cannot be used is not kept.
struct LogPressure {
  core::Microseconds time{};      ///< at most oldest_pressure before the tick
  std::uint32_t pressure_pa = 0;  ///< not zero
};
inline constexpr core::Microseconds oldest_pressure{65'000};

/// One tick as a log keeps it: what went into the flight law, and enough of what came out to see whether a replay gives
/// the same. Everything else is made again by the law.
struct LogTick {
  core::Microseconds time{};  ///< in the frame's head

  core::Microseconds imu_time{};  ///< when the sample was measured
  std::array<std::int16_t, 3> rate_counts{};
  std::array<std::int16_t, 3> specific_force_counts{};
  DeviceStatus imu_status = DeviceStatus::no_reading;

  std::optional<LogSecondGyro> second_gyro{};

  std::optional<LogPressure> pressure{};

  core::Microseconds accelerometer_time{};
  std::array<std::int16_t, 3> accelerometer_counts{};
  DeviceStatus accelerometer_status = DeviceStatus::no_reading;

  std::array<std::uint16_t, core::canard_count> encoder_counts{};  ///< 0 to 16383
  std::array<DeviceStatus, core::canard_count> encoder_status{};

  bool arm_switch_closed = false;
  bool arm_command = false;
  bool start_command = false;
  bool abort = false;

  core::Phase phase = core::Phase::safe;
  core::CommandStatus command_status = core::CommandStatus::outside_control;
  bool saturated = false;
  bool timing_fault = false;
  core::Angle command{};  ///< of the roll, every bit of it
  /// The commanded shaft angles, to 0.001 degrees; empty: not driven.
  std::array<std::optional<core::Angle>, core::canard_count> canard_commands{};
  core::Microseconds duration_before{};  ///< of the tick before this one; saturates at 65535 us
  std::uint32_t digest = 0;              ///< tick_digest() of the whole record
};

/// Measurement times are kept as an age of up to 65534 us. An older sample is one that came before: its time is that of
/// the tick before, which whoever packs or unpacks a row of ticks has at hand. (A checkpoint does not say it of the
/// second gyro: a sample of that age is none to the flight law, whatever its time.)
struct SampleTimes {
  core::Microseconds imu{};
  core::Microseconds accelerometer{};
  core::Microseconds second_gyro{};
};

inline constexpr std::size_t log_tick_size = 50;
inline constexpr std::size_t second_gyro_size = 9;  ///< behind it, where two gyros fly
inline constexpr std::size_t pressure_size = 6;     ///< behind these, with a barometer
inline constexpr std::size_t largest_log_tick = log_tick_size + second_gyro_size + pressure_size;
using PackedTick = std::array<std::byte, log_tick_size>;

/// How large a packed tick is.
[[nodiscard]] constexpr std::size_t log_tick_size_with(bool second_gyro, bool barometer) {
  return log_tick_size + (second_gyro ? second_gyro_size : 0) + (barometer ? pressure_size : 0);
}

/// `times`: of the tick before; becomes those of this one. `out`: as log_tick_size_with(). A second gyro or a pressure
/// that comes although there is no room for it is left out: by a bit that flips in the plan.
void pack(const LogTick& tick, SampleTimes& times, std::span<std::byte> out);
/// Of one gyro.
[[nodiscard]] inline PackedTick pack(const LogTick& tick, SampleTimes& times) {
  PackedTick out;
  pack(tick, times, out);
  return out;
}

/// Without the room for a pressure where it has none: so it is written, because two gyros and a barometer in every tick
/// would be more than the slowest flash takes.
[[nodiscard]] std::span<const std::byte> without_empty_room(std::span<const std::byte> packed);

/// Empty for a payload of another size and for values that no tick can have. `times` as in pack().
[[nodiscard]] std::optional<LogTick> unpack_tick(core::Microseconds time, std::span<const std::byte> payload,
                                                 SampleTimes& times);

}  // namespace fantail::protocol
