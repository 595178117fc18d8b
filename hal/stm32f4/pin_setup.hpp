// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/gpio.hpp"

namespace fantail::hal::stm32f4 {

enum class PinMode : std::uint8_t { input = 0, output = 1, alternate = 2, analog = 3 };
enum class PinPull : std::uint8_t { none = 0, up = 1, down = 2 };
/// How steep its edges are. No steeper than needed: the servos' and the sensors' wires are antennas.
enum class PinSpeed : std::uint8_t { slow = 0, medium = 1, fast = 2, fastest = 3 };

/// One row of a pin map.
struct PinSetup {
  char port = 'A';
  std::uint8_t number = 0;
  PinMode mode = PinMode::input;
  std::uint8_t alternate = 0;  ///< 0 to 15, for PinMode::alternate
  PinPull pull = PinPull::none;
  PinSpeed speed = PinSpeed::slow;
  bool high = false;  ///< an output's first level, there before the pin drives
};

/// Sets one pin up. The port's clock runs.
void set_up(registers::Gpio& port, const PinSetup& pin);

}  // namespace fantail::hal::stm32f4
