// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Which interrupts are on, and which wait. Armv7-M B3.4; the numbers are those of RM0090 table 62.
struct Nvic {
  Register iser[8];
  Register reserved_20[24];
  Register icer[8];
  Register reserved_a0[24];
  Register ispr[8];
};
static_assert(offsetof(Nvic, icer) == 0x080);
static_assert(offsetof(Nvic, ispr) == 0x100);

}  // namespace fantail::hal::stm32f4::registers
