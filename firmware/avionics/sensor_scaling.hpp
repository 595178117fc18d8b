// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "core/canard_mixer.hpp"
#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "hal/accelerometer.hpp"
#include "hal/barometer.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "hal/servo.hpp"

namespace fantail::avionics {

// Raw counts to SI, in one place, so that a replay of recorded counts gives the flight's own numbers.

/// A gyro that stands at either end of its range has lost the angle: such a sample is invalid.
[[nodiscard]] core::GyroSample gyro_sample(const hal::ImuSample& raw, const hal::ImuScale& scale);

/// Saturated when the axial channel stands at its positive end.
[[nodiscard]] core::AccelerometerSample accelerometer_sample(hal::Microseconds time, const hal::Counts& counts,
                                                             hal::Status status, float scale_m_s2);

[[nodiscard]] inline std::optional<core::PressureSample> pressure_sample(
    const std::optional<hal::BarometerSample>& raw) {
  return raw ? std::optional{core::PressureSample{.time = raw->time,
                                                  .pressure_pa = static_cast<float>(raw->pressure_pa)}}
             : std::nullopt;
}

/// Shaft angles in (-180, 180] degrees about the plan's encoder zeros; empty where the device reported no valid reading
/// or a count that one turn does not have.
[[nodiscard]] core::EncoderAngles encoder_angles(const hal::EncoderReading& raw, const core::CanardsPlan& canards);

/// Servo pulses, to the nearest nanosecond; empty for a canard that is not driven.
[[nodiscard]] std::array<std::optional<hal::Pulse>, hal::canards> pulses(const core::CanardCommands& commands);

}  // namespace fantail::avionics
