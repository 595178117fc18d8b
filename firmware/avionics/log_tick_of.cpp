// SPDX-License-Identifier: MIT
#include "avionics/log_tick_of.hpp"

#include <optional>

#include "avionics/sensor_scaling.hpp"
#include "core/per_canard.hpp"
#include "protocol/tick_digest.hpp"

namespace fantail::avionics {
namespace {

// The two enumerations say the same; the protocol knows no hardware layer.
template <hal::Status status, protocol::DeviceStatus same>
constexpr bool alike = static_cast<int>(status) == static_cast<int>(same);
static_assert(alike<hal::Status::ok, protocol::DeviceStatus::ok>);
static_assert(alike<hal::Status::error, protocol::DeviceStatus::error>);
static_assert(alike<hal::Status::no_reading, protocol::DeviceStatus::no_reading>);

protocol::DeviceStatus to_log(hal::Status status) { return static_cast<protocol::DeviceStatus>(status); }

hal::Status from_log(protocol::DeviceStatus status) { return static_cast<hal::Status>(status); }

// A count that one turn does not have is no reading, and 14 bits could not say so.
bool on_the_turn(const hal::EncoderSample& encoder) { return encoder.counts < hal::encoder_counts_per_turn; }

}  // namespace

protocol::LogTick log_tick_of(const core::TickRecord& record, const RawSamples& raw, const core::Inputs& inputs,
                              core::Microseconds duration_before) {
  const auto& encoders = raw.encoders.each;
  return {
      .time = inputs.time,
      .imu_time = raw.imu.time,
      .rate_counts = raw.imu.rate,
      .specific_force_counts = raw.imu.specific_force,
      .imu_status = to_log(raw.imu.status),
      .second_gyro = raw.second_imu ? std::optional{protocol::LogSecondGyro{.time = raw.second_imu->time,
                                                                            .rate_counts = raw.second_imu->rate,
                                                                            .status = to_log(raw.second_imu->status)}}
                                    : std::nullopt,
      .pressure = raw.barometer ? std::optional{protocol::LogPressure{.time = raw.barometer->time,
                                                                      .pressure_pa = raw.barometer->pressure_pa}}
                                : std::nullopt,
      .accelerometer_time = raw.accelerometer.time,
      .accelerometer_counts = raw.accelerometer.specific_force,
      .accelerometer_status = to_log(raw.accelerometer.status),
      .encoder_counts = core::per_canard(
          [&](std::size_t i) { return on_the_turn(encoders[i]) ? encoders[i].counts : std::uint16_t{0}; }),
      .encoder_status = core::per_canard([&](std::size_t i) {
        const bool fits = on_the_turn(encoders[i]) || encoders[i].status != hal::Status::ok;
        return fits ? to_log(encoders[i].status) : protocol::DeviceStatus::error;
      }),
      .arm_switch_closed = inputs.arm_switch_closed,
      .arm_command = inputs.arm_command,
      .start_command = inputs.start_command,
      .abort = inputs.abort,
      .phase = record.phase,
      .command_status = record.command_status,
      .saturated = record.saturated,
      .timing_fault = record.timing_fault,
      .command = record.command,
      .canard_commands = core::per_canard([&](std::size_t i) {
        return record.canards[i].driven ? std::optional{record.canards[i].angle} : std::nullopt;
      }),
      .duration_before = duration_before,
      .digest = protocol::tick_digest(record),
  };
}

protocol::SampleTimes sample_times(const RawSamples& raw) {
  return {.imu = raw.imu.time,
          .accelerometer = raw.accelerometer.time,
          .second_gyro = raw.second_imu ? raw.second_imu->time : core::Microseconds{}};
}

RawSamples raw_samples_of(const protocol::LogTick& tick) {
  RawSamples raw{
      .imu = {.time = tick.imu_time,
              .rate = tick.rate_counts,
              .specific_force = tick.specific_force_counts,
              .status = from_log(tick.imu_status)},
      .accelerometer = {.time = tick.accelerometer_time,
                        .specific_force = tick.accelerometer_counts,
                        .status = from_log(tick.accelerometer_status)},
      .encoders = {.time = tick.time},
  };
  if (tick.second_gyro) {
    raw.second_imu = hal::ImuSample{.time = tick.second_gyro->time,
                                    .rate = tick.second_gyro->rate_counts,
                                    .status = from_log(tick.second_gyro->status)};
  }
  if (tick.pressure) {
    raw.barometer = hal::BarometerSample{
        .time = tick.pressure->time, .pressure_pa = tick.pressure->pressure_pa, .status = hal::Status::ok};
  }
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    raw.encoders.each[i] = {.counts = tick.encoder_counts[i], .status = from_log(tick.encoder_status[i])};
  }
  return raw;
}

namespace {

std::optional<core::GyroSample> second_gyro_sample(const RawSamples& raw, const SampleScales& scales) {
  if (!raw.second_imu) {
    return std::nullopt;
  }
  return gyro_sample(*raw.second_imu, {.rate_rad_s = scales.second_rate_rad_s, .specific_force_m_s2 = 0.0F});
}

}  // namespace

core::Inputs sensed(core::Microseconds time, const RawSamples& raw, const SampleScales& scales,
                    const core::CanardsPlan& canards) {
  return {
      .time = time,
      .gyro = gyro_sample(raw.imu, scales.imu),
      .second_gyro = second_gyro_sample(raw, scales),
      .accelerometers = {accelerometer_sample(raw.imu.time, raw.imu.specific_force, raw.imu.status,
                                              scales.imu.specific_force_m_s2),
                         accelerometer_sample(raw.accelerometer.time, raw.accelerometer.specific_force,
                                              raw.accelerometer.status, scales.accelerometer_m_s2)},
      .barometer = pressure_sample(raw.barometer),
      .encoders = encoder_angles(raw.encoders, canards),
  };
}

core::Inputs inputs_of(const protocol::LogTick& tick, const SampleScales& scales, const core::CanardsPlan& canards) {
  core::Inputs inputs = sensed(tick.time, raw_samples_of(tick), scales, canards);
  inputs.arm_switch_closed = tick.arm_switch_closed;
  inputs.arm_command = tick.arm_command;
  inputs.start_command = tick.start_command;
  inputs.abort = tick.abort;
  return inputs;
}

}  // namespace fantail::avionics
