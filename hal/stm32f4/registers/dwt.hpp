// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Data watchpoint and trace unit, of which the cycle counter is used. Armv7-M C1.8.
struct Dwt {
  Register ctrl;
  Register cyccnt;
};
static_assert(offsetof(Dwt, cyccnt) == 0x04);

inline constexpr std::uint32_t dwt_ctrl_cyccntena = 1U << 0U;
inline constexpr std::uint32_t dwt_ctrl_nocyccnt = 1U << 25U;  ///< this processor has none

/// Core debug. Armv7-M C1.6.
struct CoreDebug {
  Register dhcsr;
  Register dcrsr;
  Register dcrdr;
  Register demcr;
};
static_assert(offsetof(CoreDebug, demcr) == 0x0C);

inline constexpr std::uint32_t demcr_trcena = 1U << 24U;  ///< without it the trace units do not answer

}  // namespace fantail::hal::stm32f4::registers
