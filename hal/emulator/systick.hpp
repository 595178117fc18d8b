// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/emulator/stopwatch.hpp"

namespace fantail::hal::emulator {

/// The processor's own timer (ARMv7-M Architecture Reference Manual, B3.3), which counts its clock downwards. The one
/// timer whose period QEMU keeps.
class SysTick final : public Stopwatch {
 public:
  enum class Use : std::uint8_t {
    pace,  ///< an interrupt every `period` counts
    free,  ///< no interrupt ever; counts() is right when it is asked every 2^24 counts or more often
  };
  SysTick(Use use, std::uint32_t period);

  [[nodiscard]] std::uint32_t counts() override;

  /// Waits for the next interrupt. Says how many have come since the last call: 1, or more when time was short.
  [[nodiscard]] std::uint32_t wait();

  /// By the interrupt.
  static void pass();

 private:
  Use use_;
  std::uint32_t seen_ = 0;
  std::uint32_t last_ = 0;   ///< of the counter, when it runs free
  std::uint32_t total_ = 0;  ///< likewise
};

}  // namespace fantail::hal::emulator
