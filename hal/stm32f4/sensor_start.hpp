// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal::stm32f4 {

/// How a sensor is to be found by its driver.
enum class SensorStart : std::uint8_t {
  power_up,   ///< all the time there is on a pad: reset, self-test
  in_flight,  ///< only the processor was reset: a sensor that still runs as it was told to is taken as it is
};

}  // namespace fantail::hal::stm32f4
