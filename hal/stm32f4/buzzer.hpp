// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/tim.hpp"

namespace fantail::hal::stm32f4 {

/// A buzzer without a tone of its own, at the first channel of an advanced timer. Silent at power-up.
class Buzzer {
 public:
  /// `timer_hz`: what the timer counts before its prescaler. `tone_hz`: 16 Hz or more.
  Buzzer(registers::Tim& timer, std::uint32_t timer_hz, std::uint32_t tone_hz);

  /// May be said as often as one likes: only a change reaches the timer.
  void sound(bool on);

 private:
  registers::Tim* timer_;
  std::uint32_t half_a_wave_;  ///< us
  bool on_ = false;
};

}  // namespace fantail::hal::stm32f4
