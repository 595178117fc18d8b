// SPDX-License-Identifier: MIT
// The avionics on a real board, with the world at the end of its serial port: hardware in the loop. Sensors, servos,
// bus and flash are the world's; what is real is the processor, its clock and the serial port. The servo outputs stay
// off.
#include <cstdint>

#include "boards/emulator/target.hpp"
#include "boards/emulator/usart_channel.hpp"
#include "boards/stm32f405/peripherals.hpp"
#include "boards/stm32f405/pin_map.hpp"
#include "hal/emulator/systick.hpp"
#include "hal/stm32f4/clock_tree.hpp"
#include "hal/stm32f4/console.hpp"

namespace {

using namespace fantail;  // NOLINT
namespace stm32 = hal::stm32f4;
namespace board = boards::stm32f405;

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
  const stm32::ClockTree clocks = stm32::start_clocks(board::rcc(), board::flash_interface(), board::pwr());
  stm32::enable_peripherals(board::rcc());
  for (const stm32::PinSetup& pin : board::pin_map) {
    if (pin.port == 'A' && (pin.number == 9 || pin.number == 10)) {
      stm32::set_up(board::port(pin.port), pin);
    }
  }
  static stm32::Console console{board::usart1(),
                                {board::nvic().ispr[usart_1_interrupt / 32U], usart_1_interrupt},
                                clocks.frequencies.apb2_hz,
                                baud};
  port = &console;
  board::nvic().iser[usart_1_interrupt / 32U].write(1U << (usart_1_interrupt % 32U));
  static boards::emulator::UsartChannel channel{console};
  static hal::emulator::SysTick stopwatch;
  static constexpr boards::emulator::Measured measured{};
  static boards::emulator::Target target{channel, stopwatch, "fantail-hil", measured};
  for (;;) {
    target.serve(0);
  }
}
