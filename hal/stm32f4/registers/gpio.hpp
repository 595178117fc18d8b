// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// One port of 16 pins. RM0090 section 8.4.
struct Gpio {
  Register moder;
  Register otyper;
  Register ospeedr;
  Register pupdr;
  Register idr;
  Register odr;
  Register bsrr;
  Register lckr;
  Register afr[2];
};
static_assert(offsetof(Gpio, idr) == 0x10);
static_assert(offsetof(Gpio, bsrr) == 0x18);
static_assert(offsetof(Gpio, afr) == 0x20);

}  // namespace fantail::hal::stm32f4::registers
