// SPDX-License-Identifier: MIT
#include "hal/stm32f4/clock.hpp"

#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t ticks_per_second = 1000;
constexpr std::uint32_t microseconds_per_tick = 1000;

}  // namespace

Clock::Clock(SysTick& timer, const Scb& system, std::uint32_t core_hz)
    : timer_{&timer}, system_{&system}, counts_per_tick_{core_hz / ticks_per_second} {
  timer.load.write(counts_per_tick_ - 1);
  timer.val.write(0);  // any value clears it, and it starts from LOAD
  timer.ctrl.write(systick_ctrl_enable | systick_ctrl_tickint | systick_ctrl_clksource);
}

Microseconds Clock::now() const {
  constexpr int most_attempts = 4;  // a second one only when the interrupt came in between, which is once a millisecond
  for (int attempt = 1;; ++attempt) {
    const std::int64_t ticks = ticks_;
    std::uint32_t left = timer_->val.read();
    const bool not_yet_served = system_->icsr.any(scb_icsr_pendstset);
    if (not_yet_served) {
      // Zero was passed before or after that look at the timer; it certainly was before this one.
      left = timer_->val.read();
    }
    if (ticks_ == ticks || attempt == most_attempts) {
      return base_ + at(not_yet_served ? ticks + 1 : ticks, left, not_yet_served);
    }
  }
}

// The timer counts down to zero, where its interrupt becomes pending; one count later it stands at LOAD. At zero
// without an interrupt the millisecond is over all the same: an emulator sets the flag a moment later.
Microseconds Clock::at(std::int64_t ticks, std::uint32_t left, bool begun_now) const {
  const std::uint32_t counts = begun_now && left == 0 ? 0 : counts_per_tick_ - left;
  return Microseconds{ticks * microseconds_per_tick + counts * microseconds_per_tick / counts_per_tick_};
}

std::uint32_t Clock::wait_for_tick() {
  const std::int64_t due = next_tick_.value_or(ticks_ + 1);
  // Between the look at the count and the sleep no interrupt may come in, or the processor would sleep through it.
  mask_interrupts();
  while (ticks_ < due) {
    wait_for_interrupt();
    unmask_interrupts();
    mask_interrupts();
  }
  unmask_interrupts();
  const std::int64_t begun = ticks_;
  next_tick_ = begun + 1;
  return static_cast<std::uint32_t>(begun - due);
}

}  // namespace fantail::hal::stm32f4
