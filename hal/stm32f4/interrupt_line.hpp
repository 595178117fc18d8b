// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4 {

/// A way to call an interrupt handler from outside of it, so that only the handler ever touches what is its own.
/// Armv7-M B3.4.4: writing a one makes the interrupt pending, writing zeros changes nothing.
class InterruptLine {
 public:
  /// `set_pending`: the NVIC_ISPR word that has this interrupt.
  InterruptLine(registers::Register& set_pending, std::uint8_t number)
      : set_pending_{&set_pending}, mask_{1U << (number % 32U)} {}
  void pend() { set_pending_->write(mask_); }

 private:
  registers::Register* set_pending_;
  std::uint32_t mask_;
};

}  // namespace fantail::hal::stm32f4
