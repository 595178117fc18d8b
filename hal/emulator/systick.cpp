// SPDX-License-Identifier: MIT
#include "hal/emulator/systick.hpp"

namespace fantail::hal::emulator {
namespace {

struct Registers {
  volatile std::uint32_t control;
  volatile std::uint32_t reload;
  volatile std::uint32_t value;
};
constexpr std::uint32_t enable = 1U << 0U;
constexpr std::uint32_t processor_clock = 1U << 2U;
constexpr std::uint32_t longest_period = 1U << 24U;

Registers& registers() { return *reinterpret_cast<Registers*>(0xE000E010); }

// Some 2000 instructions, which take QEMU hardly longer than one: it translates and counts them together.
void do_nothing() { __asm volatile(".rept 2000\n nop\n .endr"); }

}  // namespace

SysTick::SysTick(std::uint32_t period) : period_{period} {
  registers().control = 0;
  registers().reload = longest_period - 1;
  registers().value = 0;
  registers().control = enable | processor_clock;
}

std::uint32_t SysTick::counts() {
  const std::uint32_t now = registers().value;
  total_ += (last_ - now) & (longest_period - 1);
  last_ = now;
  return total_;
}

// Neither by an interrupt nor asleep: for each of them QEMU wakes another of its threads, and a processor that sleeps
// (WFI) is woken by that thread again. That would be ten changes between threads in every millisecond.
std::uint32_t SysTick::wait() {
  // Of do_nothing(), at 8 ns an instruction; fewer in truth, so that the end of the period is approached from below.
  constexpr std::uint32_t most_counts = 4096;
  for (;;) {
    const std::uint32_t passed = counts() - period_begin_;
    if (passed >= period_) {
      const std::uint32_t periods = passed / period_;
      period_begin_ += periods * period_;
      return periods;
    }
    for (std::uint32_t rounds = (period_ - passed) / most_counts + 1; rounds > 0; --rounds) {
      do_nothing();
    }
  }
}

}  // namespace fantail::hal::emulator
