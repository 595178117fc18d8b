// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/angle.hpp"
#include "core/time.hpp"
#include "core/vector3.hpp"

namespace fantail::core {

/// Canards 1 to 4 are at indices 0 to 3, here and in every array of them.
inline constexpr std::size_t canard_count = 4;
/// 1 g: the standard acceleration of free fall (CGPM 1901), not that of the place.
inline constexpr float standard_gravity_m_s2 = 9.80665F;

// Beyond any sensor that fits a rocket (1000 g, 16 turns a second): what reads more is not a measurement. The attitude
// step stays a rotation up to twice this rate.
inline constexpr float largest_specific_force_m_s2 = 10'000.0F;
inline constexpr float largest_rate_rad_s = 100.0F;

/// What the hardware layer knows about a sample before anybody looks at its value.
enum class SampleQuality : std::uint8_t {
  valid,      ///< as far as the device knows; whether its value can be true is asked later
  saturated,  ///< the axial channel stands at the end of its range, the true value is beyond it: an accelerometer's at
              ///< its positive end, a gyro's at either
  invalid,    ///< the device answered, but with an error
  absent,     ///< nothing has been read yet, or the device does not answer
};

/// Angular rate in the body frame.
struct GyroSample {
  Microseconds time{};  ///< when it was measured, by the clock of Inputs::time
  Vector3 rate_rad_s{};
  SampleQuality quality = SampleQuality::absent;
};

/// Specific force in the body frame; x reads +1 g on the pad.
struct AccelerometerSample {
  Microseconds time{};  ///< when it was measured, by the clock of Inputs::time
  Vector3 specific_force_m_s2{};
  SampleQuality quality = SampleQuality::absent;
};

/// Pressure of the air around the rocket.
struct PressureSample {
  Microseconds time{};  ///< when it was measured, by the clock of Inputs::time
  float pressure_pa = 0.0F;
};

/// Angle of one canard about its own shaft, encoder zero already taken off. Empty when the encoder had nothing valid.
using EncoderAngles = std::array<std::optional<Angle>, canard_count>;

/// Everything one control tick may know. A sample that was seen before has an unchanged `time`.
struct Inputs {
  Microseconds time{};  ///< of this tick: a sample of a later time is rejected
  GyroSample gyro{};
  std::optional<GyroSample> second_gyro{};              ///< empty where the plan asks for one
  std::array<AccelerometerSample, 2> accelerometers{};  ///< of the IMU, and the second one
  std::optional<PressureSample> barometer{};            ///< in a tick in which it has a new one
  EncoderAngles encoders{};
  bool arm_switch_closed = false;  ///< debounced
  bool arm_command = false;        ///< the second, independent action: one tick long
  bool start_command = false;      ///< tunnel only: begin control now, one tick long
  bool abort = false;              ///< debounced: the abort contact stands as, by the plan, ends control
  /// Canard angles asked for by the pad self-test or an open bench session; obeyed in Safe only.
  std::optional<std::array<Angle, canard_count>> canard_request{};
};

}  // namespace fantail::core
