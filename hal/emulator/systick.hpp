// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/emulator/stopwatch.hpp"

namespace fantail::hal::emulator {

/// The processor's own timer (ARMv7-M Architecture Reference Manual, B3.3), which counts its clock downwards, 24 bits.
/// It runs free and never interrupts.
class SysTick final : public Stopwatch {
 public:
  /// `period` of wait(), in counts, from now on.
  explicit SysTick(std::uint32_t period = 1U << 24U);

  /// Right when it is asked every 2^24 counts or more often.
  [[nodiscard]] std::uint32_t counts() override;

  /// Waits for the end of the period. Says how many have ended since the last call: 1, or more when time was short.
  [[nodiscard]] std::uint32_t wait();

 private:
  std::uint32_t period_;
  std::uint32_t period_begin_ = 0;
  std::uint32_t last_ = 0;  ///< of the counter
  std::uint32_t total_ = 0;
};

}  // namespace fantail::hal::emulator
