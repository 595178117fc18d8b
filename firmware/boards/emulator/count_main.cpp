// SPDX-License-Identifier: MIT
// The avionics on an emulated processor that counts the instructions of every tick and of the flight law in it. Nothing
// interrupts it. The linker puts the counter around the flight law (--wrap), so the counted objects are those that fly.
#include "boards/emulator/target.hpp"
#include "core/autopilot.hpp"
#include "hal/emulator/semihosting.hpp"
#include "hal/emulator/semihosting_channel.hpp"
#include "hal/emulator/systick.hpp"

using namespace fantail;  // NOLINT
using hal::emulator::SysTick;

namespace {

volatile std::uint32_t step_counts = 0;
SysTick* clock_now = nullptr;

std::uint32_t loop(std::uint32_t rounds) {
  const std::uint32_t begin = clock_now->counts();
  __asm volatile("1: subs %0, #1\n bne 1b" : "+l"(rounds) : : "cc");
  return clock_now->counts() - begin;
}

// Two instructions a round, and everything around the loop is in both.
boards::emulator::Measured calibrate() {
  constexpr std::uint32_t rounds = 10'000;
  const std::uint32_t one = loop(rounds);
  const std::uint32_t two = loop(2 * rounds);
  return {.instructions = 2 * rounds, .counts = two - one, .step = &step_counts};
}

}  // namespace

extern "C" {

void systick_handler() {}

void crash_handler() {
  hal::emulator::semihosting::say("the emulated processor crashed\n");
  hal::emulator::semihosting::exit(false);
}

const core::TickRecord& __real__ZN7fantail4core9Autopilot4stepERKNS0_6InputsE(core::Autopilot*, const core::Inputs&);

const core::TickRecord& __wrap__ZN7fantail4core9Autopilot4stepERKNS0_6InputsE(core::Autopilot* autopilot,
                                                                              const core::Inputs& inputs) {
  const std::uint32_t begin = clock_now->counts();
  const core::TickRecord& record = __real__ZN7fantail4core9Autopilot4stepERKNS0_6InputsE(autopilot, inputs);
  step_counts = clock_now->counts() - begin - clock_now->cost();
  clock_now->leave_out(2 * clock_now->cost());
  return record;
}
}

int main() {
  static SysTick clock;
  clock.find_cost();
  clock_now = &clock;
  static hal::emulator::SemihostingChannel channel;
  static const boards::emulator::Measured measured = calibrate();
  static boards::emulator::Target target{channel, clock, "fantail-count", measured};
  for (;;) {
    target.serve(0);
  }
}
