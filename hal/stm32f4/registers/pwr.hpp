// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Power control of the STM32F405. RM0090 section 5.4.
struct Pwr {
  Register cr;
  Register csr;
};
static_assert(offsetof(Pwr, csr) == 0x04);

// Section 5.4.1.
inline constexpr std::uint32_t pwr_cr_pvde = 1U << 4U;  ///< the voltage detector runs
inline constexpr std::uint32_t pwr_cr_pls = 7U << 5U;   ///< its level; 7 is the highest
inline constexpr std::uint32_t pwr_cr_dbp = 1U << 8U;   ///< the backup domain may be written
inline constexpr std::uint32_t pwr_cr_vos = 1U << 14U;  ///< scale 1, which 168 MHz needs
// Section 5.4.2.
inline constexpr std::uint32_t pwr_csr_pvdo = 1U << 2U;  ///< the supply is below the detector's level

}  // namespace fantail::hal::stm32f4::registers
