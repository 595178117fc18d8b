// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Independent watchdog. RM0090 section 21.4.
struct Iwdg {
  Register kr;
  Register pr;
  Register rlr;
  Register sr;
};
static_assert(offsetof(Iwdg, sr) == 0x0C);

// Section 21.4.1: keys, not bits.
inline constexpr std::uint32_t iwdg_kr_unlock = 0x5555;  ///< PR and RLR may be written
inline constexpr std::uint32_t iwdg_kr_reload = 0xAAAA;
inline constexpr std::uint32_t iwdg_kr_start = 0xCCCC;
// Section 21.4.2.
inline constexpr std::uint32_t iwdg_pr_divide_by_4 = 0;
// Section 21.4.4.
inline constexpr std::uint32_t iwdg_sr_pvu = 1U << 0U;  ///< a new prescaler is on its way
inline constexpr std::uint32_t iwdg_sr_rvu = 1U << 1U;  ///< a new reload value is

}  // namespace fantail::hal::stm32f4::registers
