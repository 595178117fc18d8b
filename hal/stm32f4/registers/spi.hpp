// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// RM0090 section 28.5.
struct Spi {
  Register cr1;
  Register cr2;
  Register sr;
  Register dr;
  Register crcpr;
  Register rxcrcr;
  Register txcrcr;
  Register i2scfgr;
  Register i2spr;
};
static_assert(offsetof(Spi, sr) == 0x08);
static_assert(offsetof(Spi, dr) == 0x0C);
static_assert(offsetof(Spi, i2spr) == 0x20);

namespace spi {

// CR1, section 28.5.1.
inline constexpr std::uint32_t clock_phase = 1U << 0U;     ///< CPHA: sampled at the second edge
inline constexpr std::uint32_t clock_polarity = 1U << 1U;  ///< CPOL: high while idle
inline constexpr std::uint32_t master = 1U << 2U;
inline constexpr std::uint32_t prescaler_shift = 3;  ///< BR: the bus clock is divided by 2 to the power of BR + 1
inline constexpr std::uint32_t prescaler_mask = 7U << prescaler_shift;
inline constexpr std::uint32_t enable = 1U << 6U;
// SSI and SSM: selected by software, so that the NSS pin is an ordinary pin and no mode fault can happen.
inline constexpr std::uint32_t internal_select = 1U << 8U;
inline constexpr std::uint32_t software_select = 1U << 9U;

// SR, section 28.5.3.
inline constexpr std::uint32_t received = 1U << 0U;        ///< RXNE
inline constexpr std::uint32_t transmit_empty = 1U << 1U;  ///< TXE
inline constexpr std::uint32_t overrun = 1U << 6U;         ///< OVR
inline constexpr std::uint32_t busy = 1U << 7U;            ///< BSY

}  // namespace spi

}  // namespace fantail::hal::stm32f4::registers
