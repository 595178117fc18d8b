// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::sim {

/// What each random stream of a scenario's seed is for. A new one is added at the end: the others then stay as they
/// are.
struct RandomStream {
  enum : std::uint8_t {
    imu_noise = 1,
    accelerometer_noise,
    encoder_noise,
    turbulence,
    servo_spread,
    shaking,
    second_imu_noise,
    faults,
    barometer_noise
  };
};

}  // namespace fantail::sim
