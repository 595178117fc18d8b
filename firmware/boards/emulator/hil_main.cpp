// SPDX-License-Identifier: MIT
// The avionics on a real board, with the world at the end of its serial port: hardware in the loop. Sensors, servos,
// bus and flash are the world's; what is real is the processor, its clock and the serial port. The servo outputs stay
// off.
#include <cstdint>

#include "boards/emulator/target.hpp"
#include "boards/emulator/usart_channel.hpp"
#include "boards/stm32f405/pin_map.hpp"
#include "hal/emulator/systick.hpp"
#include "hal/stm32f4/clock_tree.hpp"
#include "hal/stm32f4/console.hpp"

namespace {

using namespace fantail;  // NOLINT
namespace stm32 = hal::stm32f4;
namespace registers = hal::stm32f4::registers;

// RM0090 table 1, section 12.2 and PM0214 section 4.3.
auto& rcc = *reinterpret_cast<registers::Rcc*>(0x40023800);
auto& flash_interface = *reinterpret_cast<registers::FlashInterface*>(0x40023C00);
auto& pwr = *reinterpret_cast<registers::Pwr*>(0x40007000);
auto& gpio_a = *reinterpret_cast<registers::Gpio*>(0x40020000);
auto& usart_1 = *reinterpret_cast<registers::Usart*>(0x40011000);
auto& set_enabled = *reinterpret_cast<registers::Register*>(0xE000E104);  // interrupts 32 to 63
auto& set_pending = *reinterpret_cast<registers::Register*>(0xE000E204);
constexpr std::uint8_t usart_1_interrupt = 37;
constexpr std::uint32_t baud = 921'600;

stm32::Console* port = nullptr;

}  // namespace

extern "C" {

void systick_handler() {}

void usart1_handler() { port->on_interrupt(); }

// Nothing moves that would have to be centred; the world notices the silence.
void crash_handler() {
  for (;;) {
    __asm volatile("wfi");
  }
}
}

int main() {
  const stm32::ClockTree clocks = stm32::start_clocks(rcc, flash_interface, pwr);
  stm32::enable_peripherals(rcc);
  for (const stm32::PinSetup& pin : boards::stm32f405::pin_map) {
    if (pin.port == 'A' && (pin.number == 9 || pin.number == 10)) {
      stm32::set_up(gpio_a, pin);
    }
  }
  static stm32::Console console{usart_1, {set_pending, usart_1_interrupt}, clocks.frequencies.apb2_hz, baud};
  port = &console;
  set_enabled.write(1U << (usart_1_interrupt % 32U));
  static boards::emulator::UsartChannel channel{console};
  static hal::emulator::SysTick stopwatch{hal::emulator::SysTick::Use::free, 0};
  static constexpr boards::emulator::Measured measured{};
  static boards::emulator::Target target{channel, stopwatch, "fantail-hil", measured};
  for (;;) {
    target.serve(0);
  }
}
