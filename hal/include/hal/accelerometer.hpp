// SPDX-License-Identifier: MIT
#pragma once

#include "hal/sample.hpp"

namespace fantail::hal {

/// One measurement, as it was read.
struct AccelerometerSample {
  Microseconds time{};  ///< when it was measured
  Counts specific_force{};
  Status status = Status::no_reading;
};

/// The second accelerometer, independent of the one in the IMU.
class Accelerometer {
 public:
  virtual ~Accelerometer() = default;
  /// The latest sample. Never waits; a sample already seen comes again with its old time.
  virtual AccelerometerSample read() = 0;
  /// m/s2 per count, as configured.
  [[nodiscard]] virtual float scale() const = 0;
};

}  // namespace fantail::hal
