// SPDX-License-Identifier: MIT
// The avionics on an emulated processor, a thousand times a second by its own clock.
#include "boards/emulator/target.hpp"
#include "hal/emulator/semihosting.hpp"
#include "hal/emulator/semihosting_channel.hpp"
#include "hal/emulator/systick.hpp"

using namespace fantail;  // NOLINT
using hal::emulator::SysTick;

extern "C" void systick_handler() {}

extern "C" void crash_handler() {
  hal::emulator::semihosting::say("the emulated processor crashed\n");
  hal::emulator::semihosting::exit(false);
}

int main() {
  constexpr std::uint32_t counts_per_millisecond = 168'000;
  static SysTick clock{counts_per_millisecond};
  static hal::emulator::SemihostingChannel channel;
  static constexpr boards::emulator::Measured measured{};
  static boards::emulator::Target target{channel, clock, "fantail-emulator", measured};
  for (;;) {
    target.serve(clock.wait() - 1);
  }
}
