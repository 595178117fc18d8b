// SPDX-License-Identifier: MIT
#pragma once

#include "hal/sample.hpp"

namespace fantail::hal {

/// One measurement of both, as it was read.
struct ImuSample {
  Microseconds time{};      ///< when it was measured
  Counts rate{};            ///< no_counts: of the gyro there is nothing to be used
  Counts specific_force{};  ///< the same of the accelerometer
  Status status = Status::no_reading;
};

/// SI units per count, as configured.
struct ImuScale {
  float rate_rad_s;
  float specific_force_m_s2;
};

/// Gyro and accelerometer in one package.
class Imu {
 public:
  virtual ~Imu() = default;
  /// The latest sample. Never waits; a sample already seen comes again with its old time.
  virtual ImuSample read() = 0;
  /// What one count of a sample is.
  [[nodiscard]] virtual ImuScale scale() const = 0;
};

}  // namespace fantail::hal
