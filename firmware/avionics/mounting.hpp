// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/flight_plan.hpp"
#include "hal/accelerometer.hpp"
#include "hal/imu.hpp"
#include "hal/sample.hpp"

namespace fantail::avionics {

/// Turns a sensor's counts into the rocket's axes: x to the nose, y and z across, right-handed.
class Mounting {
 public:
  /// `plan` has passed core::validate(): its two axes are different ones.
  constexpr explicit Mounting(const core::SensorMounting& plan)
      : x_{axis(plan.to_nose)},
        y_{axis(plan.along_y)},
        // The third axis is the cross product of the two.
        z_{.index = static_cast<std::uint8_t>(3U - x_.index - y_.index),
           .negative = (x_.negative != y_.negative) != ((x_.index + 1U) % 3U != y_.index)} {}

  [[nodiscard]] constexpr hal::Counts turned(const hal::Counts& sensor) const {
    // The lower end means more than "at least this much" when it stands on all axes; turned, it would not.
    return sensor == hal::no_counts ? sensor : hal::Counts{of(sensor, x_), of(sensor, y_), of(sensor, z_)};
  }

 private:
  struct Axis {
    std::uint8_t index;
    bool negative;
  };

  [[nodiscard]] static constexpr Axis axis(core::SensorAxis axis) {
    return {.index = static_cast<std::uint8_t>(static_cast<unsigned>(axis) / 2U),
            .negative = static_cast<unsigned>(axis) % 2U == 1U};
  }

  // Full scale stays full scale when its sign changes: whoever reads it takes either end of the range for "at least
  // this much".
  [[nodiscard]] static constexpr std::int16_t of(const hal::Counts& sensor, Axis axis) {
    using Limits = std::numeric_limits<std::int16_t>;
    const std::int16_t count = sensor[axis.index];
    if (!axis.negative) {
      return count;
    }
    if (count == Limits::max()) {
      return Limits::min();
    }
    return count == Limits::min() ? Limits::max() : static_cast<std::int16_t>(-count);
  }

  Axis x_;
  Axis y_;
  Axis z_;
};

/// From here on, and in the log, counts are along the axes of the rocket.
[[nodiscard]] inline hal::ImuSample turned(hal::ImuSample sample, const core::SensorMounting& plan) {
  const Mounting mounting{plan};
  sample.rate = mounting.turned(sample.rate);
  sample.specific_force = mounting.turned(sample.specific_force);
  return sample;
}

[[nodiscard]] inline hal::AccelerometerSample turned(hal::AccelerometerSample sample,
                                                     const core::SensorMounting& plan) {
  sample.specific_force = Mounting{plan}.turned(sample.specific_force);
  return sample;
}

}  // namespace fantail::avionics
