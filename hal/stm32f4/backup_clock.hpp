// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hal/clock.hpp"
#include "hal/stm32f4/registers/rcc.hpp"
#include "hal/stm32f4/registers/rtc.hpp"

namespace fantail::hal::stm32f4 {

/// The real-time clock on its crystal of 32.768 kHz, which a reset of the processor does not stop: RM0090 says so of
/// this crystal, and not of the internal oscillator, whose switch is reset. In steps of 31 us, from 0 to a day, and
/// then from 0 again.
///
/// A crystal takes seconds to start after a power-up: until then, and for ever where there is none, there is no time.
class BackupClock {
 public:
  /// The backup domain must be open for writing.
  BackupClock(registers::Rcc& rcc, registers::Rtc& device);

  /// Once a tick: one more step, and no wait, to a clock that runs.
  void update();

  [[nodiscard]] std::optional<Microseconds> now() const;

 private:
  registers::Rcc* rcc_;
  registers::Rtc* device_;
  bool runs_ = false;
};

}  // namespace fantail::hal::stm32f4
