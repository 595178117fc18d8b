// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/tim.hpp"

namespace fantail::hal::stm32f4 {

/// When a line rose last, to the microsecond, noted by the capture unit of a timer of 32 bits (channel 4 of TIM2).
///
/// No interrupt: the hardware keeps the count of the latest edge in one register, which is read in one load. So nothing
/// can be torn, nobody has to be fast, and a line that floats and has thousands of edges in a millisecond costs no
/// time.
class EdgeTimer {
 public:
  /// The count at an edge. It wraps after 71 minutes.
  using Edge = std::uint32_t;

  /// `timer_hz`: what the timer counts before its prescaler, whole megahertz.
  [[gnu::cold]] EdgeTimer(registers::Tim& timer, std::uint32_t timer_hz);

  /// The latest one; before the first, the count 0.
  [[nodiscard]] Edge last_edge() const { return timer_->ccr[3].read(); }
  /// More than one edge came since last_edge() was asked for the last time. Forgets it.
  bool take_overrun();
  /// What is counted now.
  [[nodiscard]] Edge now() const { return timer_->cnt.read(); }

 private:
  registers::Tim* timer_;
};

}  // namespace fantail::hal::stm32f4
