// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// External interrupts and events: which of its 23 lines had an edge. RM0090 section 12.3.
struct Exti {
  Register imr;
  Register emr;
  Register rtsr;
  Register ftsr;
  Register swier;
  Register pr;  ///< a one that is written clears its bit
};
static_assert(offsetof(Exti, pr) == 0x14);

inline constexpr std::uint32_t exti_voltage_detector = 1U << 16U;  ///< section 12.2.5: its output is line 16

}  // namespace fantail::hal::stm32f4::registers
