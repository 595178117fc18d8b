// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// How the processor reads its own flash. RM0090 section 3.9; the registers that program it are not used.
struct FlashInterface {
  Register acr;
};

// Section 3.9.1.
inline constexpr std::uint32_t flash_acr_latency = 7U << 0U;  ///< wait states
inline constexpr std::uint32_t flash_acr_prften = 1U << 8U;
inline constexpr std::uint32_t flash_acr_icen = 1U << 9U;
inline constexpr std::uint32_t flash_acr_dcen = 1U << 10U;

}  // namespace fantail::hal::stm32f4::registers
