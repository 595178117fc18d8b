// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/clock.hpp"
#include "hal/stm32f4/registers/systick.hpp"

namespace fantail::hal::stm32f4 {

/// Time from the processor's own timer: whole milliseconds counted by its interrupt, and between them what the timer
/// has counted since. It is right also where the interrupt has to wait, as long as that is less than a millisecond.
class Clock final : public hal::Clock {
 public:
  /// Time begins here. `core_hz` is a whole number of kilohertz, below 4 GHz.
  Clock(registers::SysTick& timer, const registers::Scb& system, std::uint32_t core_hz);

  /// Time goes on at `time`, as after a reset in flight. Before anybody has read the clock.
  void begin_at(Microseconds time) { base_ = time - (now() - base_); }

  /// For the interrupt handler of the timer only.
  void tick() { ticks_ = ticks_ + 1; }

  [[nodiscard]] Microseconds now() const override;

  /// How long ago the latest millisecond began, below 1 ms.
  [[nodiscard]] Microseconds since_tick() const { return (now() - base_) % Microseconds{1'000}; }

  /// Returns when the next millisecond since the last call has begun; how many others have begun meanwhile, unseen. A
  /// loop that comes too late begins at once. What bounds this wait is the watchdog.
  std::uint32_t wait_for_tick();

 private:
  [[nodiscard]] Microseconds at(std::int64_t ticks, std::uint32_t left, bool begun_now) const;

  registers::SysTick* timer_;
  const registers::Scb* system_;
  std::uint32_t counts_per_tick_;
  Microseconds base_{};
  volatile std::int64_t ticks_ = 0;        ///< written by the handler alone
  std::optional<std::int64_t> next_tick_;  ///< none before the loop has begun
};

}  // namespace fantail::hal::stm32f4
