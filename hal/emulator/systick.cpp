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
constexpr std::uint32_t interrupt = 1U << 1U;
constexpr std::uint32_t processor_clock = 1U << 2U;
constexpr std::uint32_t longest_period = 1U << 24U;

Registers& registers() { return *reinterpret_cast<Registers*>(0xE000E010); }

volatile std::uint32_t passed = 0;
std::uint32_t period_now = longest_period;

}  // namespace

SysTick::SysTick(Use use, std::uint32_t period) : use_{use} {
  period_now = use == Use::free ? longest_period : period;
  registers().control = 0;
  registers().reload = period_now - 1;
  registers().value = 0;
  registers().control = enable | processor_clock | (use == Use::pace ? interrupt : 0U);
}

std::uint32_t SysTick::counts() {
  if (use_ == Use::free) {
    const std::uint32_t now = registers().value;
    total_ += (last_ - now) & (longest_period - 1);
    last_ = now;
    return total_;
  }
  for (;;) {
    const std::uint32_t before = passed;
    const std::uint32_t value = registers().value;
    if (before == passed) {
      return before * period_now + (period_now - 1 - value);
    }
  }
}

// Not by sleeping: for a processor that sleeps (WFI) QEMU wakes another of its threads, which moves the clock on and
// wakes the processor's again. That is six more changes between threads in every millisecond. A long run of
// instructions that do nothing is hardly more work for it than one instruction: it counts them all at once.
std::uint32_t SysTick::wait() {
  while (passed == seen_) {
    __asm volatile(".rept 400\n nop\n .endr");
  }
  const std::uint32_t now = passed;
  const std::uint32_t count = now - seen_;
  seen_ = now;
  return count;
}

void SysTick::pass() { passed = passed + 1; }

}  // namespace fantail::hal::emulator
