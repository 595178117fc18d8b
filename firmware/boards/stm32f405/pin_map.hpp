// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hal/stm32f4/pin_setup.hpp"

namespace fantail::boards::stm32f405 {

// Every pin that the firmware uses, once. docs/hardware.md is the same table with wires; alternate functions are those
// of the data sheet's table 9 (DS8626). Not to be taken for something else: PA11 and PA12 (USB, for the boot loader),
// PA13 and PA14 (probe), PC14 and PC15 (a 32 kHz crystal on many boards), PH0 and PH1 (8 MHz crystal).
using hal::stm32f4::PinMode;
using hal::stm32f4::PinPull;
using hal::stm32f4::PinSetup;
using hal::stm32f4::PinSpeed;

[[nodiscard]] constexpr PinSetup spi(char port, std::uint8_t number, std::string_view use, std::uint8_t alternate,
                                     PinPull pull = PinPull::none) {
  return {port, number, use, PinMode::alternate, alternate, pull, PinSpeed::fast, false};
}
// Nobody is selected until a driver selects it.
[[nodiscard]] constexpr PinSetup select(char port, std::uint8_t number, std::string_view use) {
  return {port, number, use, PinMode::output, 0, PinPull::none, PinSpeed::medium, true};
}

// clang-format off: a table
inline constexpr std::array pin_map{
    // An output that is switched off is pulled low, so a servo without pulses sees silence and not noise.
    PinSetup{'C', 6, "servo 1, TIM8_CH1", PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},
    PinSetup{'C', 7, "servo 2, TIM8_CH2", PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},
    PinSetup{'C', 8, "servo 3, TIM8_CH3", PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},
    PinSetup{'C', 9, "servo 4, TIM8_CH4", PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},

    select('A', 4, "IMU select"),
    spi('A', 5, "IMU clock, SPI1_SCK", 5),
    // A sensor that is not there reads as zeros, which no sensor answers.
    spi('A', 6, "IMU data out, SPI1_MISO", 5, PinPull::down),
    spi('A', 7, "IMU data in, SPI1_MOSI", 5),

    select('B', 12, "encoder 1 select"),
    select('B', 0, "encoder 2 select"),
    select('B', 1, "encoder 3 select"),
    select('C', 5, "encoder 4 select"),
    spi('B', 13, "encoder clock, SPI2_SCK", 5),
    spi('B', 14, "encoder data out, SPI2_MISO", 5, PinPull::down),
    spi('B', 15, "encoder data in, SPI2_MOSI", 5),

    select('C', 4, "second accelerometer select"),
    select('A', 15, "flash select"),
    spi('B', 3, "accelerometer and flash clock, SPI3_SCK", 6),
    spi('B', 4, "accelerometer and flash data out, SPI3_MISO", 6, PinPull::down),
    spi('B', 5, "accelerometer and flash data in, SPI3_MOSI", 6),

    PinSetup{'B', 8, "CAN receive, CAN1_RX", PinMode::alternate, 9, PinPull::up, PinSpeed::medium, false},
    PinSetup{'B', 9, "CAN transmit, CAN1_TX", PinMode::alternate, 9, PinPull::none, PinSpeed::medium, false},
    // High until the controller is set up: a node that cannot talk must not disturb those who can.
    PinSetup{'C', 0, "CAN transceiver silent", PinMode::output, 0, PinPull::none, PinSpeed::slow, true},

    PinSetup{'A', 9, "console transmit, USART1_TX", PinMode::alternate, 7, PinPull::none, PinSpeed::medium, false},
    PinSetup{'A', 10, "console receive, USART1_RX", PinMode::alternate, 7, PinPull::up, PinSpeed::slow, false},

    PinSetup{'C', 2, "battery divider, ADC1_IN12", PinMode::analog, 0, PinPull::none, PinSpeed::slow, false},
    // Closed means high: a wire that has come off is an open switch, and an open switch does not arm.
    PinSetup{'C', 3, "arm switch", PinMode::input, 0, PinPull::down, PinSpeed::slow, false},
    PinSetup{'B', 2, "status light", PinMode::output, 0, PinPull::none, PinSpeed::slow, false},
    PinSetup{'A', 8, "buzzer, TIM1_CH1", PinMode::alternate, 1, PinPull::down, PinSpeed::slow, false},
};
// clang-format on

// No pin has two uses.
static_assert([] {
  for (std::size_t i = 0; i < pin_map.size(); ++i) {
    for (std::size_t k = i + 1; k < pin_map.size(); ++k) {
      if (pin_map[i].port == pin_map[k].port && pin_map[i].number == pin_map[k].number) {
        return false;
      }
    }
  }
  return true;
}());

}  // namespace fantail::boards::stm32f405
