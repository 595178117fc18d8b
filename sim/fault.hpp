// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/board.hpp"
#include "sim/misbehaviour.hpp"

namespace fantail::sim {

/// What can go wrong in a run. The canard_ kinds are those of ServoFault.
enum class FaultKind : std::uint8_t {
  canard_stuck,
  canard_hardover,
  canard_dead,
  canard_slipping,
  canard_reversed,
  canard_slow,
  canard_wrong_trim,
  encoder_unplugged,
  encoder_noisy,
  imu_dropout,
  accelerometer_dropout,
  imu_frozen,
  imu_offset,
  second_imu_dropout,
  second_imu_frozen,
  second_imu_offset,
  reset,
  device,  ///< Fault::misbehaviour says what
};

/// Of a sensor by a name of its own: lasts for a while and concerns no canard.
[[nodiscard]] constexpr bool is_of_sensor(FaultKind kind) {
  return kind >= FaultKind::imu_dropout && kind <= FaultKind::second_imu_offset;
}

[[nodiscard]] constexpr bool is_of_second_imu(FaultKind kind) {
  return kind >= FaultKind::second_imu_dropout && kind <= FaultKind::second_imu_offset;
}

[[nodiscard]] constexpr bool is_offset(FaultKind kind) {
  return kind == FaultKind::imu_offset || kind == FaultKind::second_imu_offset;
}

/// Concerns the processor.
[[nodiscard]] constexpr bool is_reset(FaultKind kind) { return kind == FaultKind::reset; }

/// Any device by any behaviour.
[[nodiscard]] constexpr bool is_of_device(FaultKind kind) { return kind == FaultKind::device; }

enum class MemoryAfterReset : std::uint8_t { kept, lost };

/// A reset of the processor: for so long it has no ticks, and then the avionics begins anew. Until the reset a hanging
/// loop leaves the pulses as they are; from the reset to the first tick there are none.
struct Reset {
  hal::ResetCause cause = hal::ResetCause::watchdog;
  double gap_s = 0.06;
  MemoryAfterReset memory = MemoryAfterReset::kept;
  double clock_error_s = 0.0;  ///< by so much the avionics takes the gap for longer than it was
};

/// Of any gap this much, or all of a shorter one, is the start of the firmware, in which the lines are low.
inline constexpr double start_of_firmware_s = 0.010;

struct Fault {
  FaultKind kind;
  std::size_t canard;  ///< 0 to 3; for canard and encoder faults, of a device too
  double from_s;       ///< after ignition (in the tunnel: after the start command); negative on the pad, and before
                       ///< power-up it is there from the first tick
  double until_s;      ///< of sensors and devices only
  std::optional<double> angle_rad{};  ///< stuck and wrong_trim only, as Servo::fail
  double noise_counts = 60.0;         ///< encoder_noisy only: standard deviation of its readings
  double rate_offset_rad_s = 0.0;     ///< offset only: added to the gyro's rate about the long axis
  Reset reset{};                      ///< reset only
  Misbehaviour misbehaviour{};        ///< device only
};

}  // namespace fantail::sim
