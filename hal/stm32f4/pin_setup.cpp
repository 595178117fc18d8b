// SPDX-License-Identifier: MIT
#include "hal/stm32f4/pin_setup.hpp"

namespace fantail::hal::stm32f4 {

void set_up(registers::Gpio& port, const PinSetup& pin) {
  const std::uint32_t number = pin.number;
  const auto two_bits = [number](auto value) { return static_cast<std::uint32_t>(value) << (2 * number); };
  port.bsrr.write(1U << (pin.high ? number : number + 16));
  port.pupdr.change(two_bits(3), two_bits(pin.pull));
  port.ospeedr.change(two_bits(3), two_bits(pin.speed));
  const std::uint32_t place = 4 * (number % 8);
  port.afr[number / 8].change(0xFU << place, static_cast<std::uint32_t>(pin.alternate) << place);
  // Last: only now does the pin do something, and then all at once.
  port.moder.change(two_bits(3), two_bits(pin.mode));
}

}  // namespace fantail::hal::stm32f4
