// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "hal/accelerometer.hpp"
#include "hal/barometer.hpp"
#include "hal/board.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "hal/servo.hpp"

namespace fantail::hal::sim {

/// The world's face of the simulated hardware: what the world puts in before a tick and takes out after it. The
/// avionics never sees it; it holds the devices beside this file, which read from here.
struct WorldSide {
  Microseconds time{};
  ImuSample imu{};
  ImuScale imu_scale{};
  bool second_imu_is_fitted = false;
  ImuSample second_imu{};
  ImuScale second_imu_scale{};
  AccelerometerSample accelerometer{};
  float accelerometer_scale_m_s2 = 0.0F;
  bool barometer_is_fitted = false;
  BarometerSample barometer{};
  EncoderReading encoders{};
  bool arm_switch_closed = false;     ///< its contacts now, which may bounce
  bool abort_contact_closed = false;  ///< likewise
  BoardStatus board{};
  std::array<std::optional<Pulse>, canards> pulses{};  ///< what the avionics wrote last
  Signal shown = Signal::safe;                         ///< by lamp and buzzer
  Microseconds watchdog_fed{};                         ///< when the avionics last completed a tick
  bool had_tick = true;                      ///< false: an avionics that runs by itself had none in this millisecond
  std::optional<ResetCause> restarted_by{};  ///< what began such a one anew since the tick before; empty: nothing did
};

}  // namespace fantail::hal::sim
