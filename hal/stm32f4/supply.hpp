// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/board.hpp"
#include "hal/stm32f4/registers/exti.hpp"
#include "hal/stm32f4/registers/pwr.hpp"

namespace fantail::hal::stm32f4 {

/// The processor's supply of 3.3 V, watched by its voltage detector at the highest of its levels: low below 3.03 V
/// (2.95 to 3.09), good again above 3.14 V (3.07 to 3.21). The brown-out reset at its highest level comes below 2.83 V
/// (2.75 to 2.88), so a supply that sinks is told of before it resets. (Data sheet DS8626, table 19.)
///
/// A dip is shorter than a tick. The external-interrupt block keeps the edge until a tick looks, so no interrupt is
/// needed; it is unmasked there, and not in the interrupt controller.
class Supply {
 public:
  Supply(registers::Pwr& power, registers::Exti& lines);

  /// Once a tick.
  void update();
  /// Until a second after the supply was low last: long enough for everybody to hear of it.
  [[nodiscard]] BoardFaults faults() const;

  static constexpr std::uint32_t ticks_told = 1'000;

 private:
  registers::Pwr* power_;
  registers::Exti* lines_;
  bool looked_ = false;
  std::uint32_t ticks_left_ = 0;
};

}  // namespace fantail::hal::stm32f4
