// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "hal/accelerometer.hpp"
#include "hal/barometer.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::avionics {

// Between what the devices gave and what a flight log keeps, in one place, so that a replay feeds the flight law with
// the flight's own inputs.

/// What the devices gave in one tick.
struct RawSamples {
  hal::ImuSample imu;
  std::optional<hal::ImuSample> second_imu{};  ///< empty where the plan asks for one gyro
  hal::AccelerometerSample accelerometer;
  std::optional<hal::BarometerSample> barometer{};  ///< a new one that can be used, where the plan asks for one
  hal::EncoderReading encoders;
};

/// What a count of each device stands for.
struct SampleScales {
  hal::ImuScale imu{};
  float second_rate_rad_s = 0.0F;
  float accelerometer_m_s2 = 0.0F;
};

/// A tick as a log keeps it. `inputs` are those that made `record`, without which a replay could not make it again.
[[nodiscard]] protocol::LogTick log_tick_of(const core::TickRecord& record, const RawSamples& raw,
                                            const core::Inputs& inputs, core::Microseconds duration_before);

/// When all that was measured.
[[nodiscard]] protocol::SampleTimes sample_times(const RawSamples& raw);

/// What the devices gave, as far as the flight law can tell.
[[nodiscard]] RawSamples raw_samples_of(const protocol::LogTick& tick);

/// What the sensors tell the flight law, in flight and in a replay; of switches and commands nothing.
[[nodiscard]] core::Inputs sensed(core::Microseconds time, const RawSamples& raw, const SampleScales& scales,
                                  const core::CanardsPlan& canards);

/// Everything that the flight law may know of this tick. (A canard request is obeyed in Safe only, and no log has one.)
[[nodiscard]] core::Inputs inputs_of(const protocol::LogTick& tick, const SampleScales& scales,
                                     const core::CanardsPlan& canards);

}  // namespace fantail::avionics
