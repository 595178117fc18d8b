// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// How the processor reads its own flash, and its option bytes as they were when it was reset. RM0090 section 3.9; the
/// registers that program either are not used.
struct FlashInterface {
  Register acr;
  Register keyr;
  Register optkeyr;
  Register sr;
  Register cr;
  Register optcr;
};
static_assert(offsetof(FlashInterface, optcr) == 0x14);

// Section 3.9.1.
inline constexpr std::uint32_t flash_acr_latency = 7U << 0U;  ///< wait states
inline constexpr std::uint32_t flash_acr_prften = 1U << 8U;
inline constexpr std::uint32_t flash_acr_icen = 1U << 9U;
inline constexpr std::uint32_t flash_acr_dcen = 1U << 10U;
// Section 3.9.6.
inline constexpr std::uint32_t flash_optcr_bor_lev = 3U << 2U;  ///< 0: level 3, reset below 2.7 V; 3: off

}  // namespace fantail::hal::stm32f4::registers
