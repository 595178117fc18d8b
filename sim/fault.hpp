// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

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
};

/// Lasts for a while and concerns no canard.
[[nodiscard]] constexpr bool is_dropout(FaultKind kind) {
  return kind == FaultKind::imu_dropout || kind == FaultKind::accelerometer_dropout;
}

struct Fault {
  FaultKind kind;
  std::size_t canard;  ///< 0 to 3; for canard and encoder faults
  double from_s;       ///< after ignition (in the tunnel: after the start command); negative on the pad, and before
                       ///< power-up it is there from the first tick
  double until_s;      ///< dropouts only
  std::optional<double> angle_rad{};  ///< stuck and wrong_trim only, as Servo::fail
  double noise_counts = 60.0;         ///< encoder_noisy only: standard deviation of its readings
};

}  // namespace fantail::sim
