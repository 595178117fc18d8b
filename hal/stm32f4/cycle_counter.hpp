// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "hal/stm32f4/registers/dwt.hpp"

namespace fantail::hal::stm32f4 {

/// How many cycles of the processor the longest piece of work took, interrupts within it included: up to 2^32, 25 s at
/// 168 MHz. The processor counts them itself; one that does not, such as an emulated one, has no number.
class CycleCounter {
 public:
  CycleCounter(registers::Dwt& unit, registers::CoreDebug& debug) : unit_{&unit} {
    debug.demcr.set(registers::demcr_trcena);
    unit.ctrl.set(registers::dwt_ctrl_cyccntena);
    counts_ = unit.ctrl.any(registers::dwt_ctrl_cyccntena) && !unit.ctrl.any(registers::dwt_ctrl_nocyccnt);
  }

  void begin() {
    if (counts_) {
      begun_ = unit_->cyccnt.read();
    }
  }
  /// Without a begin() it is no piece of work.
  void end() {
    if (const auto begun = std::exchange(begun_, std::nullopt)) {
      longest_ = std::max(longest_.value_or(0), unit_->cyccnt.read() - *begun);
    }
  }
  /// Since this was asked last.
  [[nodiscard]] std::optional<std::uint32_t> take_longest() { return std::exchange(longest_, std::nullopt); }

 private:
  registers::Dwt* unit_;
  bool counts_ = false;
  std::optional<std::uint32_t> begun_{};
  std::optional<std::uint32_t> longest_{};
};

}  // namespace fantail::hal::stm32f4
