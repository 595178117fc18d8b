// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hal/clock.hpp"

namespace fantail::hal {

/// The quality of a reading, as reported by the device.
enum class Status : std::uint8_t {
  ok,          ///< as far as the device knows
  error,       ///< it answered with an error flag, a bad parity or a failed self-check
  no_reading,  ///< it has not answered at all
};

/// Three signed axes as the converter delivers them, along the axes of the sensor: how it is mounted says the plan. A
/// count at either end of its range means "at least this much".
using Counts = std::array<std::int16_t, 3>;

/// The lower end on all three axes: there is nothing to be used, however the sensor is mounted.
inline constexpr Counts no_counts{-32768, -32768, -32768};

}  // namespace fantail::hal
