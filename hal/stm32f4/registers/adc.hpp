// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// One converter. RM0090 section 13.13.
struct Adc {
  Register sr;
  Register cr1;
  Register cr2;
  Register smpr[2];  ///< of channels 10 to 18, then of 0 to 9
  Register jofr[4];
  Register htr;
  Register ltr;
  Register sqr[3];
  Register jsqr;
  Register jdr[4];
  Register dr;
};
static_assert(offsetof(Adc, smpr) == 0x0C);
static_assert(offsetof(Adc, sqr) == 0x2C);
static_assert(offsetof(Adc, dr) == 0x4C);

/// What the three converters share, 0x300 behind the first. Section 13.13.16.
struct AdcCommon {
  Register csr;
  Register ccr;
};
static_assert(offsetof(AdcCommon, ccr) == 0x04);

// Section 13.13.1.
inline constexpr std::uint32_t adc_sr_eoc = 1U << 1U;  ///< cleared by reading DR
// Section 13.13.3.
inline constexpr std::uint32_t adc_cr2_adon = 1U << 0U;
inline constexpr std::uint32_t adc_cr2_swstart = 1U << 30U;
// Section 13.13.4: of channel 10; each further one lies 3 bits higher.
inline constexpr std::uint32_t adc_smpr_480_cycles = 7U;
inline constexpr std::uint32_t adc_smpr_bits_per_channel = 3;
// Section 13.13.16.
inline constexpr std::uint32_t adc_ccr_divide_by_4 = 1U << 16U;

}  // namespace fantail::hal::stm32f4::registers
