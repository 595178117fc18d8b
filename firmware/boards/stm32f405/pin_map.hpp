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

[[nodiscard]] constexpr PinSetup spi(char port, std::uint8_t number, std::uint8_t alternate,
                                     PinPull pull = PinPull::none) {
  return {port, number, PinMode::alternate, alternate, pull, PinSpeed::fast, false};
}
// Nobody is selected until a driver selects it.
[[nodiscard]] constexpr PinSetup select(char port, std::uint8_t number) {
  return {port, number, PinMode::output, 0, PinPull::none, PinSpeed::medium, true};
}

// clang-format off: a table
inline constexpr auto pin_map = std::to_array<PinSetup>({
    // An output that is switched off is pulled low, so a servo without pulses sees silence and not noise.
    PinSetup{'C', 6, PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},  // servo 1, TIM8_CH1
    PinSetup{'C', 7, PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},  // servo 2, TIM8_CH2
    PinSetup{'C', 8, PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},  // servo 3, TIM8_CH3
    PinSetup{'C', 9, PinMode::alternate, 3, PinPull::down, PinSpeed::slow, false},  // servo 4, TIM8_CH4

    select('A', 4),  // IMU select
    // The steepest edges there are: at 84 MHz of APB2 a slow one corrupts the last bit of what comes in, because the block
    // takes it with the clock that comes back from this pin (errata sheet ES0182; the bit rate does not matter).
    PinSetup{'A', 5, PinMode::alternate, 5, PinPull::none, PinSpeed::fastest, false},  // IMU clock, SPI1_SCK
    // A sensor that is not there reads as zeros, which no sensor answers.
    spi('A', 6, 5, PinPull::down),  // IMU data out, SPI1_MISO
    spi('A', 7, 5),  // IMU data in, SPI1_MOSI
    // A wire that is off has no edges.
    PinSetup{'A', 3, PinMode::alternate, 1, PinPull::down, PinSpeed::slow, false},  // IMU data ready, TIM2_CH4

    select('B', 12),  // encoder 1 select
    select('B', 0),  // encoder 2 select
    select('B', 1),  // encoder 3 select
    select('C', 5),  // encoder 4 select
    spi('B', 13, 5),  // encoder clock, SPI2_SCK
    spi('B', 14, 5, PinPull::down),  // encoder data out, SPI2_MISO
    spi('B', 15, 5),  // encoder data in, SPI2_MOSI

    select('C', 4),  // second accelerometer select
    select('A', 15),  // flash select
    select('B', 11),  // second IMU select
    select('B', 10),  // barometer select
    spi('B', 3, 6),  // accelerometer, flash, second IMU and barometer clock, SPI3_SCK
    spi('B', 4, 6, PinPull::down),  // their data out, SPI3_MISO
    spi('B', 5, 6),  // their data in, SPI3_MOSI

    PinSetup{'B', 8, PinMode::alternate, 9, PinPull::up, PinSpeed::medium, false},  // CAN receive, CAN1_RX
    PinSetup{'B', 9, PinMode::alternate, 9, PinPull::none, PinSpeed::medium, false},  // CAN transmit, CAN1_TX
    // High until the controller is set up: a node that cannot talk must not disturb those who can.
    PinSetup{'C', 0, PinMode::output, 0, PinPull::none, PinSpeed::slow, true},  // CAN transceiver silent

    PinSetup{'A', 9, PinMode::alternate, 7, PinPull::none, PinSpeed::medium, false},  // console transmit, USART1_TX
    PinSetup{'A', 10, PinMode::alternate, 7, PinPull::up, PinSpeed::slow, false},  // console receive, USART1_RX

    PinSetup{'C', 2, PinMode::analog, 0, PinPull::none, PinSpeed::slow, false},  // battery divider, ADC1_IN12
    // Closed means high: a wire that has come off is an open switch, and an open switch does not arm.
    PinSetup{'C', 3, PinMode::input, 0, PinPull::down, PinSpeed::slow, false},  // arm switch
    // Closed means low, to ground: which of the two levels aborts is in the plan.
    PinSetup{'C', 1, PinMode::input, 0, PinPull::up, PinSpeed::slow, false},  // abort contact
    PinSetup{'B', 2, PinMode::output, 0, PinPull::none, PinSpeed::slow, false},  // status light
    PinSetup{'A', 8, PinMode::alternate, 1, PinPull::down, PinSpeed::slow, false},  // buzzer, TIM1_CH1
});
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
