// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// TIM1 and TIM8, RM0090 section 17.4; TIM2 and TIM5 lie the same, without repetitions and break, TIM5 with
/// an option (section 18.4).
struct Tim {
  Register cr1;
  Register cr2;
  Register smcr;
  Register dier;
  Register sr;
  Register egr;
  Register ccmr[2];
  Register ccer;
  Register cnt;
  Register psc;
  Register arr;
  Register rcr;
  Register ccr[4];
  Register bdtr;
  Register dcr;
  Register dmar;
  Register option;
};
static_assert(offsetof(Tim, egr) == 0x14);
static_assert(offsetof(Tim, ccmr) == 0x18);
static_assert(offsetof(Tim, ccer) == 0x20);
static_assert(offsetof(Tim, psc) == 0x28);
static_assert(offsetof(Tim, ccr) == 0x34);
static_assert(offsetof(Tim, bdtr) == 0x44);
static_assert(offsetof(Tim, option) == 0x50);

// Section 17.4.1.
inline constexpr std::uint32_t tim_cr1_cen = 1U << 0U;
inline constexpr std::uint32_t tim_cr1_udis = 1U << 1U;  ///< no update: what is preloaded stays preloaded
inline constexpr std::uint32_t tim_cr1_arpe = 1U << 7U;
// Section 17.4.5.
inline constexpr std::uint32_t tim_sr_cc4of = 1U << 12U;  ///< captured again before it was read; written zero, cleared
// Section 17.4.6.
inline constexpr std::uint32_t tim_egr_ug = 1U << 0U;
// Section 17.4.7: of the first channel of the pair; the second lies 8 bits higher.
inline constexpr std::uint32_t tim_ccmr_ocpe = 1U << 3U;      ///< the compare value is preloaded
inline constexpr std::uint32_t tim_ccmr_ocm_pwm1 = 6U << 4U;  ///< high while the counter is below the compare value
inline constexpr std::uint32_t tim_ccmr_input = 1U << 0U;     ///< the channel is an input, captured from its own pin
inline constexpr std::uint32_t tim_ccmr_input_filter_shift = 4;
inline constexpr std::uint32_t tim_ccmr_bits_per_channel = 8;
// Section 17.4.9: of the first channel; each further one lies 4 bits higher.
inline constexpr std::uint32_t tim_ccer_cce = 1U << 0U;
inline constexpr std::uint32_t tim_ccer_bits_per_channel = 4;
// Channel 4 of TIM5 as an input: sections 18.4.5, 18.4.8, 18.4.9 and 18.4.20.
inline constexpr std::uint32_t tim_sr_cc4if = 1U << 4U;         ///< captured; a read of the value clears it
inline constexpr std::uint32_t tim_ccmr2_cc4s_ti4 = 1U << 8U;   ///< its own input
inline constexpr std::uint32_t tim_ccmr2_ic4psc_8 = 3U << 10U;  ///< of eight edges the last
inline constexpr std::uint32_t tim_ccer_cc4e = 1U << 12U;
inline constexpr std::uint32_t tim5_option_ti4_rmp_lsi = 1U << 6U;  ///< which is the slow oscillator
// Section 17.4.18.
inline constexpr std::uint32_t tim_bdtr_ossi = 1U << 10U;  ///< without MOE the outputs are driven to their idle level
inline constexpr std::uint32_t tim_bdtr_moe = 1U << 15U;

}  // namespace fantail::hal::stm32f4::registers
