// SPDX-License-Identifier: MIT
#include "avionics/sensor_scaling.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/per_canard.hpp"

namespace fantail::avionics {
namespace {

using CountLimits = std::numeric_limits<std::int16_t>;

core::Vector3 scaled(const hal::Counts& counts, float scale) {
  return {static_cast<float>(counts[0]) * scale, static_cast<float>(counts[1]) * scale,
          static_cast<float>(counts[2]) * scale};
}

core::SampleQuality quality(hal::Status status) {
  switch (status) {
    case hal::Status::ok: return core::SampleQuality::valid;
    case hal::Status::error: return core::SampleQuality::invalid;
    case hal::Status::no_reading: break;
  }
  return core::SampleQuality::absent;
}

bool at_an_end(std::int16_t count) { return count == CountLimits::max() || count == CountLimits::min(); }

}  // namespace

core::GyroSample gyro_sample(const hal::ImuSample& raw, const hal::ImuScale& scale) {
  core::GyroSample sample{
      .time = raw.time, .rate_rad_s = scaled(raw.rate, scale.rate_rad_s), .quality = quality(raw.status)};
  // Across the rocket nothing turns that fast, and an IMU that has not measured yet holds the lower end on every axis.
  if (sample.quality == core::SampleQuality::valid && (at_an_end(raw.rate[1]) || at_an_end(raw.rate[2]))) {
    sample.quality = core::SampleQuality::invalid;
  } else if (sample.quality == core::SampleQuality::valid && at_an_end(raw.rate[0])) {
    sample.quality = core::SampleQuality::saturated;
  }
  return sample;
}

core::AccelerometerSample accelerometer_sample(hal::Microseconds time, const hal::Counts& counts, hal::Status status,
                                               float scale_m_s2) {
  core::AccelerometerSample sample{
      .time = time, .specific_force_m_s2 = scaled(counts, scale_m_s2), .quality = quality(status)};
  if (sample.quality == core::SampleQuality::valid && counts[0] == CountLimits::max()) {
    sample.quality = core::SampleQuality::saturated;
  }
  // No bound that anybody could use: a shock, or a device that has not measured yet.
  if (sample.quality == core::SampleQuality::valid && counts[0] == CountLimits::min()) {
    sample.quality = core::SampleQuality::invalid;
  }
  return sample;
}

core::EncoderAngles encoder_angles(const hal::EncoderReading& raw, const core::CanardsPlan& canards) {
  constexpr float turn_rad = 2.0F * core::pi;
  return core::per_canard([&](std::size_t i) -> std::optional<core::Angle> {
    if (raw.each[i].status != hal::Status::ok || raw.each[i].counts >= hal::encoder_counts_per_turn) {
      return std::nullopt;
    }
    float angle_rad = static_cast<float>(raw.each[i].counts) * (turn_rad / hal::encoder_counts_per_turn) -
                      canards.each[i].encoder_zero.radians();
    if (angle_rad > core::pi) {
      angle_rad -= turn_rad;
    } else if (angle_rad <= -core::pi) {
      angle_rad += turn_rad;
    }
    return core::Angle::from_radians(angle_rad);
  });
}

std::array<std::optional<hal::Pulse>, hal::canards> pulses(const core::CanardCommands& commands) {
  return core::per_canard([&](std::size_t i) -> std::optional<hal::Pulse> {
    if (!commands[i].driven) {
      return std::nullopt;
    }
    // A plan's pulses are below 4 ms, so the conversion cannot overflow; they are positive, so half a nanosecond up
    // is the nearest. NOLINTNEXTLINE(bugprone-incorrect-roundings): lround would be a call into the C library
    return hal::Pulse{static_cast<std::int32_t>(commands[i].pulse_us * 1000.0F + 0.5F)};
  });
}

}  // namespace fantail::avionics
