// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Random number generator. RM0090 section 24.4.
struct Rng {
  Register cr;
  Register sr;
  Register dr;
};
static_assert(offsetof(Rng, dr) == 0x08);

inline constexpr std::uint32_t rng_cr_rngen = 1U << 2U;
inline constexpr std::uint32_t rng_sr_drdy = 1U << 0U;
inline constexpr std::uint32_t rng_sr_cecs = 1U << 1U;  ///< its 48 MHz clock is too slow now
inline constexpr std::uint32_t rng_sr_secs = 1U << 2U;  ///< its noise is none now
inline constexpr std::uint32_t rng_sr_ceis = 1U << 5U;  ///< was, since it was last cleared by writing 0
inline constexpr std::uint32_t rng_sr_seis = 1U << 6U;

}  // namespace fantail::hal::stm32f4::registers
