// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Memory protection unit. Armv7-M B3.5, PM0214 section 4.2.
struct Mpu {
  Register type;
  Register ctrl;
  Register rnr;
  Register rbar;
  Register rasr;
};
static_assert(offsetof(Mpu, rasr) == 0x10);

inline constexpr std::uint32_t mpu_ctrl_enable = 1U << 0U;
inline constexpr std::uint32_t mpu_ctrl_privdefena = 1U << 2U;  ///< outside of all regions as without the unit
inline constexpr std::uint32_t mpu_rasr_enable = 1U << 0U;
inline constexpr std::uint32_t mpu_rasr_size_shift = 1;               ///< 2^(size + 1) bytes
inline constexpr std::uint32_t mpu_rasr_normal_uncached = 1U << 19U;  ///< TEX 001, C 0, B 0
inline constexpr std::uint32_t mpu_rasr_shareable = 1U << 18U;
inline constexpr std::uint32_t mpu_rasr_read_write = 3U << 24U;  ///< no access without
inline constexpr std::uint32_t mpu_rasr_never_execute = 1U << 28U;

}  // namespace fantail::hal::stm32f4::registers
