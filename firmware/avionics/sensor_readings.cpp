// SPDX-License-Identifier: MIT
#include "avionics/sensor_readings.hpp"

#include "avionics/sensor_scaling.hpp"
#include "protocol/tick_digest.hpp"

namespace fantail::avionics {
namespace {

using protocol::DeviceStatus;

static_assert(static_cast<int>(DeviceStatus::ok) == static_cast<int>(hal::Status::ok) &&
              static_cast<int>(DeviceStatus::error) == static_cast<int>(hal::Status::error) &&
              static_cast<int>(DeviceStatus::no_reading) == static_cast<int>(hal::Status::no_reading));

DeviceStatus logged(hal::Status status) { return static_cast<DeviceStatus>(status); }
hal::Status read(DeviceStatus status) { return static_cast<hal::Status>(status); }

}  // namespace

core::Inputs inputs(core::Microseconds time, const SensorReadings& readings, const SensorScales& scales,
                    const core::CanardsPlan& canards) {
  const hal::ImuSample& imu = readings.imu;
  const hal::AccelerometerSample& second = readings.accelerometer;
  return {
      .time = time,
      .gyro = gyro_sample(imu, scales.imu),
      .accelerometers = {accelerometer_sample(imu.time, imu.specific_force, imu.status, scales.imu.specific_force_m_s2),
                         accelerometer_sample(second.time, second.specific_force, second.status,
                                              scales.accelerometer_m_s2)},
      .encoders = encoder_angles(readings.encoders, canards),
      .arm_switch_closed = readings.arm_switch_closed,
      .arm_command = readings.arm_command,
      .start_command = readings.start_command,
  };
}

protocol::LogTick log_tick(const SensorReadings& readings, const core::TickRecord& record,
                           core::Microseconds duration_before) {
  protocol::LogTick tick{.time = record.time,
                         .imu_time = readings.imu.time,
                         .rate_counts = readings.imu.rate,
                         .specific_force_counts = readings.imu.specific_force,
                         .imu_status = logged(readings.imu.status),
                         .accelerometer_time = readings.accelerometer.time,
                         .accelerometer_counts = readings.accelerometer.specific_force,
                         .accelerometer_status = logged(readings.accelerometer.status),
                         .arm_switch_closed = readings.arm_switch_closed,
                         .arm_command = readings.arm_command,
                         .start_command = readings.start_command,
                         .phase = record.phase,
                         .command_status = record.command_status,
                         .saturated = record.saturated,
                         .timing_fault = record.timing_fault,
                         .command = record.command,
                         .duration_before = duration_before,
                         .digest = protocol::tick_digest(record)};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const hal::EncoderSample& encoder = readings.encoders.each[i];
    // A count that one turn does not have would come back as another one; to the flight law it is an error.
    const bool beyond_turn = encoder.counts >= hal::encoder_counts_per_turn;
    tick.encoder_counts[i] = beyond_turn ? std::uint16_t{0} : encoder.counts;
    tick.encoder_status[i] =
        beyond_turn && encoder.status == hal::Status::ok ? DeviceStatus::error : logged(encoder.status);
    if (record.canards[i].driven) {
      tick.canard_commands[i] = record.canards[i].angle;
    }
  }
  return tick;
}

SensorReadings readings(const protocol::LogTick& tick) {
  SensorReadings out{.imu = {.time = tick.imu_time,
                             .rate = tick.rate_counts,
                             .specific_force = tick.specific_force_counts,
                             .status = read(tick.imu_status)},
                     .accelerometer = {.time = tick.accelerometer_time,
                                       .specific_force = tick.accelerometer_counts,
                                       .status = read(tick.accelerometer_status)},
                     .encoders = {.time = tick.time},
                     .arm_switch_closed = tick.arm_switch_closed,
                     .arm_command = tick.arm_command,
                     .start_command = tick.start_command};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    out.encoders.each[i] = {.counts = tick.encoder_counts[i], .status = read(tick.encoder_status[i])};
  }
  return out;
}

}  // namespace fantail::avionics
