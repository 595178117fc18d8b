// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "core/time.hpp"
#include "hal/accelerometer.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::avionics {

/// What one tick reads, before anybody makes a number with a unit of it.
struct SensorReadings {
  hal::ImuSample imu{};
  hal::AccelerometerSample accelerometer{};
  hal::EncoderReading encoders{};
  bool arm_switch_closed = false;
  bool arm_command = false;
  bool start_command = false;
};

struct SensorScales {
  hal::ImuScale imu{};
  float accelerometer_m_s2 = 0.0F;
};

/// What the flight law is given; without a canard request, which counts in Safe only.
[[nodiscard]] core::Inputs inputs(core::Microseconds time, const SensorReadings& readings, const SensorScales& scales,
                                  const core::CanardsPlan& canards);

/// A tick as it is recorded.
[[nodiscard]] protocol::LogTick log_tick(const SensorReadings& readings, const core::TickRecord& record,
                                         core::Microseconds duration_before);

/// What a recorded tick had read: inputs() makes the same of it as of the original.
[[nodiscard]] SensorReadings readings(const protocol::LogTick& tick);

}  // namespace fantail::avionics
