// SPDX-License-Identifier: MIT
#include "protocol/log_tick.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/finite.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

// Offsets in the payload; log_schema.cpp says the same to readers of other versions.
constexpr std::size_t flags_at = 0;
constexpr std::size_t imu_age_at = 2;
constexpr std::size_t rate_at = 4;
constexpr std::size_t specific_force_at = 10;
constexpr std::size_t accelerometer_age_at = 16;
constexpr std::size_t accelerometer_at = 18;
constexpr std::size_t encoders_at = 24;
constexpr std::size_t command_at = 32;
constexpr std::size_t canards_at = 36;
constexpr std::size_t duration_at = 44;
constexpr std::size_t digest_at = 46;
static_assert(digest_at + 4 == log_tick_size);
constexpr std::size_t second_age_at = log_tick_size;
constexpr std::size_t second_rate_at = second_age_at + 2;
constexpr std::size_t second_status_at = second_age_at + 8;
static_assert(second_status_at + 1 == log_tick_size + second_gyro_size);
// From the end: pressure, and before it its age. A pressure of zero is none.
constexpr std::size_t pressure_from_end = 4;
constexpr std::size_t pressure_age_from_end = pressure_size;

constexpr bool has_room_for_second_gyro(std::size_t size) {
  return size == log_tick_size_with(true, false) || size == log_tick_size_with(true, true);
}
constexpr bool has_room_for_pressure(std::size_t size) {
  return size == log_tick_size_with(false, true) || size == log_tick_size_with(true, true);
}

constexpr std::uint16_t old_sample = 0xFFFF;
constexpr std::uint16_t encoder_mask = 0x3FFF;
constexpr std::int16_t not_driven = INT16_MIN;
constexpr float millidegrees_per_radian = 180'000.0F / core::pi;

std::uint16_t age(core::Microseconds now, core::Microseconds sample) {
  const std::int64_t us = (now - sample).count();
  return us >= 0 && us < old_sample ? static_cast<std::uint16_t>(us) : old_sample;
}

core::Microseconds measured(core::Microseconds now, std::uint16_t age_us, core::Microseconds before) {
  return age_us == old_sample ? before : now - core::Microseconds{age_us};
}

template <std::size_t n>
void put_counts(std::span<std::byte> out, std::size_t at, const std::array<std::int16_t, n>& counts) {
  for (std::size_t i = 0; i < n; ++i) {
    put<2>(out, at + 2 * i, static_cast<std::uint16_t>(counts[i]));
  }
}

template <std::size_t n>
void get_counts(std::span<const std::byte> in, std::size_t at, std::array<std::int16_t, n>& counts) {
  for (std::size_t i = 0; i < n; ++i) {
    counts[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(get<2>(in, at + 2 * i)));
  }
}

std::int16_t millidegrees(const std::optional<core::Angle>& angle) {
  if (!angle) {
    return not_driven;
  }
  constexpr float most = 32'767.0F;
  float value = angle->radians() * millidegrees_per_radian;
  if (std::abs(value) > most) {
    value = value > 0.0F ? most : -most;
  }
  return static_cast<std::int16_t>(value < 0.0F ? value - 0.5F : value + 0.5F);
}

struct Bits {
  std::uint32_t value = 0;
  unsigned used = 0;
  void add(std::uint32_t bits, unsigned width) {
    value |= bits << used;
    used += width;
  }
  std::uint32_t take(unsigned width) {
    const std::uint32_t bits = (value >> used) & ((1U << width) - 1U);
    used += width;
    return bits;
  }
};

}  // namespace

void pack(const LogTick& tick, SampleTimes& times, std::span<std::byte> out) {
  Bits flags;
  flags.add(static_cast<std::uint32_t>(tick.phase), 3);
  flags.add(static_cast<std::uint32_t>(tick.command_status), 2);
  flags.add(static_cast<std::uint32_t>(tick.imu_status), 2);
  flags.add(static_cast<std::uint32_t>(tick.accelerometer_status), 2);
  flags.add(tick.arm_switch_closed ? 1 : 0, 1);
  flags.add(tick.arm_command ? 1 : 0, 1);
  flags.add(tick.start_command ? 1 : 0, 1);
  flags.add(tick.saturated ? 1 : 0, 1);
  flags.add(tick.timing_fault ? 1 : 0, 1);
  flags.add(tick.abort ? 1 : 0, 1);

  put<2>(out, flags_at, flags.value);
  put<2>(out, imu_age_at, age(tick.time, tick.imu_time));
  put_counts(out, rate_at, tick.rate_counts);
  put_counts(out, specific_force_at, tick.specific_force_counts);
  put<2>(out, accelerometer_age_at, age(tick.time, tick.accelerometer_time));
  put_counts(out, accelerometer_at, tick.accelerometer_counts);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto status = static_cast<std::uint32_t>(tick.encoder_status[i]);
    put<2>(out, encoders_at + 2 * i, (tick.encoder_counts[i] & encoder_mask) | (status << 14U));
    put<2>(out, canards_at + 2 * i, static_cast<std::uint16_t>(millidegrees(tick.canard_commands[i])));
  }
  put<4>(out, command_at, std::bit_cast<std::uint32_t>(tick.command.radians()));
  put<2>(out, duration_at,
         static_cast<std::uint16_t>(std::clamp<std::int64_t>(tick.duration_before.count(), 0, UINT16_MAX)));
  put<4>(out, digest_at, tick.digest);
  times.imu = tick.imu_time;
  times.accelerometer = tick.accelerometer_time;
  if (tick.second_gyro && has_room_for_second_gyro(out.size())) {
    put<2>(out, second_age_at, age(tick.time, tick.second_gyro->time));
    put_counts(out, second_rate_at, tick.second_gyro->rate_counts);
    put<1>(out, second_status_at, static_cast<std::uint32_t>(tick.second_gyro->status));
    times.second_gyro = tick.second_gyro->time;
  }
  if (has_room_for_pressure(out.size())) {
    const LogPressure pressure = tick.pressure.value_or(LogPressure{.time = tick.time});
    put<2>(out, out.size() - pressure_age_from_end, age(tick.time, pressure.time));
    put<4>(out, out.size() - pressure_from_end, pressure.pressure_pa);
  }
}

std::span<const std::byte> without_empty_room(std::span<const std::byte> packed) {
  const std::size_t size = packed.size();
  const bool empty = has_room_for_pressure(size) && get<4>(packed, size - pressure_from_end) == 0;
  return empty ? packed.first(size - pressure_size) : packed;
}

std::optional<LogTick> unpack_tick(core::Microseconds time, std::span<const std::byte> payload, SampleTimes& times) {
  const std::size_t size = payload.size();
  if (size != log_tick_size && !has_room_for_second_gyro(size) && !has_room_for_pressure(size)) {
    return std::nullopt;
  }
  LogTick tick{.time = time};
  Bits flags{.value = static_cast<std::uint32_t>(get<2>(payload, flags_at))};
  const std::uint32_t phase = flags.take(3);
  tick.command_status = static_cast<core::CommandStatus>(flags.take(2));
  const std::uint32_t imu_status = flags.take(2);
  const std::uint32_t accelerometer_status = flags.take(2);
  constexpr std::uint32_t statuses = 3;
  if (phase >= core::phases || imu_status >= statuses || accelerometer_status >= statuses) {
    return std::nullopt;
  }
  tick.phase = static_cast<core::Phase>(phase);
  tick.imu_status = static_cast<DeviceStatus>(imu_status);
  tick.accelerometer_status = static_cast<DeviceStatus>(accelerometer_status);
  tick.arm_switch_closed = flags.take(1) != 0;
  tick.arm_command = flags.take(1) != 0;
  tick.start_command = flags.take(1) != 0;
  tick.saturated = flags.take(1) != 0;
  tick.timing_fault = flags.take(1) != 0;
  tick.abort = flags.take(1) != 0;

  tick.imu_time = measured(time, static_cast<std::uint16_t>(get<2>(payload, imu_age_at)), times.imu);
  get_counts(payload, rate_at, tick.rate_counts);
  get_counts(payload, specific_force_at, tick.specific_force_counts);
  tick.accelerometer_time =
      measured(time, static_cast<std::uint16_t>(get<2>(payload, accelerometer_age_at)), times.accelerometer);
  get_counts(payload, accelerometer_at, tick.accelerometer_counts);
  std::array<std::int16_t, core::canard_count> commands{};
  get_counts(payload, canards_at, commands);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto word = static_cast<std::uint16_t>(get<2>(payload, encoders_at + 2 * i));
    const std::uint32_t status = static_cast<std::uint32_t>(word) >> 14U;
    if (status >= statuses) {
      return std::nullopt;
    }
    tick.encoder_counts[i] = word & encoder_mask;
    tick.encoder_status[i] = static_cast<DeviceStatus>(status);
    if (commands[i] != not_driven) {
      tick.canard_commands[i] = core::Angle::from_radians(static_cast<float>(commands[i]) / millidegrees_per_radian);
    }
  }
  const auto command_rad = std::bit_cast<float>(static_cast<std::uint32_t>(get<4>(payload, command_at)));
  if (!core::is_finite(command_rad)) {
    return std::nullopt;
  }
  tick.command = core::Angle::from_radians(command_rad);
  tick.duration_before = core::Microseconds{static_cast<std::int64_t>(get<2>(payload, duration_at))};
  tick.digest = static_cast<std::uint32_t>(get<4>(payload, digest_at));
  if (has_room_for_second_gyro(size)) {
    const auto status = static_cast<std::uint32_t>(get<1>(payload, second_status_at));
    if (status >= statuses) {
      return std::nullopt;
    }
    LogSecondGyro& second = tick.second_gyro.emplace();
    second.time = measured(time, static_cast<std::uint16_t>(get<2>(payload, second_age_at)), times.second_gyro);
    get_counts(payload, second_rate_at, second.rate_counts);
    second.status = static_cast<DeviceStatus>(status);
    times.second_gyro = second.time;
  }
  if (has_room_for_pressure(size)) {
    const auto age_us = static_cast<std::int64_t>(get<2>(payload, size - pressure_age_from_end));
    const auto pressure_pa = static_cast<std::uint32_t>(get<4>(payload, size - pressure_from_end));
    if (pressure_pa > 0) {
      tick.pressure = LogPressure{.time = time - core::Microseconds{age_us}, .pressure_pa = pressure_pa};
    }
  }
  times.imu = tick.imu_time;
  times.accelerometer = tick.accelerometer_time;
  return tick;
}

}  // namespace fantail::protocol
