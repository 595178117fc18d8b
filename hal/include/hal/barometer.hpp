// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/clock.hpp"
#include "hal/sample.hpp"

namespace fantail::hal {

/// One measurement of the air's pressure, as it was read.
struct BarometerSample {
  Microseconds time{};            ///< the middle of its measurement
  std::uint32_t pressure_pa = 0;  ///< compensated by the device's own constants; a pascal is 8 cm at the ground
  Status status = Status::no_reading;
};

/// The barometer, behind the static ports of the avionics' bay. A slow device: it has something new every 10 ms or so.
class Barometer {
 public:
  virtual ~Barometer() = default;
  /// The latest sample. Never waits; a sample already seen comes again with its old time.
  virtual BarometerSample read() = 0;
};

}  // namespace fantail::hal
