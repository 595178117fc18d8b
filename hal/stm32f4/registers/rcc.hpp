// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Reset and clock control of the STM32F405. RM0090 section 7.3.
struct Rcc {
  Register cr;
  Register pllcfgr;
  Register cfgr;
  Register cir;
  Register ahb1rstr;
  Register ahb2rstr;
  Register ahb3rstr;
  Register reserved_1c;
  Register apb1rstr;
  Register apb2rstr;
  Register reserved_28[2];
  Register ahb1enr;
  Register ahb2enr;
  Register ahb3enr;
  Register reserved_3c;
  Register apb1enr;
  Register apb2enr;
  Register reserved_48[2];
  Register ahb1lpenr;
  Register ahb2lpenr;
  Register ahb3lpenr;
  Register reserved_5c;
  Register apb1lpenr;
  Register apb2lpenr;
  Register reserved_68[2];
  Register bdcr;
  Register csr;
};
static_assert(offsetof(Rcc, cir) == 0x0C);
static_assert(offsetof(Rcc, apb1rstr) == 0x20);
static_assert(offsetof(Rcc, ahb1enr) == 0x30);
static_assert(offsetof(Rcc, apb1enr) == 0x40);
static_assert(offsetof(Rcc, ahb1lpenr) == 0x50);
static_assert(offsetof(Rcc, apb1lpenr) == 0x60);
static_assert(offsetof(Rcc, bdcr) == 0x70);
static_assert(offsetof(Rcc, csr) == 0x74);

// Section 7.3.1.
inline constexpr std::uint32_t rcc_cr_hsion = 1U << 0U;
inline constexpr std::uint32_t rcc_cr_hsirdy = 1U << 1U;
inline constexpr std::uint32_t rcc_cr_hseon = 1U << 16U;
inline constexpr std::uint32_t rcc_cr_hserdy = 1U << 17U;
inline constexpr std::uint32_t rcc_cr_csson = 1U << 19U;  ///< a crystal that stops raises the NMI
inline constexpr std::uint32_t rcc_cr_pllon = 1U << 24U;
inline constexpr std::uint32_t rcc_cr_pllrdy = 1U << 25U;
// Section 7.3.2.
inline constexpr std::uint32_t rcc_pllcfgr_pllm_shift = 0;
inline constexpr std::uint32_t rcc_pllcfgr_plln_shift = 6;
inline constexpr std::uint32_t rcc_pllcfgr_pllp_shift = 16;  ///< 0 divides by 2, 1 by 4, 2 by 6, 3 by 8
inline constexpr std::uint32_t rcc_pllcfgr_pllsrc_hse = 1U << 22U;
inline constexpr std::uint32_t rcc_pllcfgr_pllq_shift = 24;
// Section 7.3.3.
inline constexpr std::uint32_t rcc_cfgr_sw = 3U << 0U;
inline constexpr std::uint32_t rcc_cfgr_sw_pll = 2U << 0U;
inline constexpr std::uint32_t rcc_cfgr_sws = 3U << 2U;
inline constexpr std::uint32_t rcc_cfgr_sws_pll = 2U << 2U;
inline constexpr std::uint32_t rcc_cfgr_ppre1_4 = 5U << 10U;
inline constexpr std::uint32_t rcc_cfgr_ppre2_2 = 4U << 13U;
// Sections 7.3.10 to 7.3.14.
inline constexpr std::uint32_t rcc_ahb1enr_gpioa = 1U << 0U;
inline constexpr std::uint32_t rcc_ahb1enr_gpiob = 1U << 1U;
inline constexpr std::uint32_t rcc_ahb1enr_gpioc = 1U << 2U;
inline constexpr std::uint32_t rcc_ahb1enr_bkpsram = 1U << 18U;
inline constexpr std::uint32_t rcc_ahb2enr_rng = 1U << 6U;
inline constexpr std::uint32_t rcc_apb1enr_tim2 = 1U << 0U;
inline constexpr std::uint32_t rcc_apb1enr_tim5 = 1U << 3U;
inline constexpr std::uint32_t rcc_apb1enr_spi2 = 1U << 14U;
inline constexpr std::uint32_t rcc_apb1enr_spi3 = 1U << 15U;
inline constexpr std::uint32_t rcc_apb1enr_can1 = 1U << 25U;
inline constexpr std::uint32_t rcc_apb1enr_pwr = 1U << 28U;
inline constexpr std::uint32_t rcc_apb2enr_tim1 = 1U << 0U;
inline constexpr std::uint32_t rcc_apb2enr_tim8 = 1U << 1U;
inline constexpr std::uint32_t rcc_apb2enr_usart1 = 1U << 4U;
inline constexpr std::uint32_t rcc_apb2enr_adc1 = 1U << 8U;
inline constexpr std::uint32_t rcc_apb2enr_spi1 = 1U << 12U;
// Section 7.3.20: of the backup domain; a system reset leaves it alone.
inline constexpr std::uint32_t rcc_bdcr_lseon = 1U << 0U;
inline constexpr std::uint32_t rcc_bdcr_lserdy = 1U << 1U;
inline constexpr std::uint32_t rcc_bdcr_rtcsel = 3U << 8U;  ///< once only, until the domain is reset
inline constexpr std::uint32_t rcc_bdcr_rtcsel_lse = 1U << 8U;
inline constexpr std::uint32_t rcc_bdcr_rtcen = 1U << 15U;
// Section 7.3.21.
inline constexpr std::uint32_t rcc_csr_lsion = 1U << 0U;
inline constexpr std::uint32_t rcc_csr_lsirdy = 1U << 1U;
inline constexpr std::uint32_t rcc_csr_rmvf = 1U << 24U;  ///< clears all that follow
inline constexpr std::uint32_t rcc_csr_borrst = 1U << 25U;
inline constexpr std::uint32_t rcc_csr_pinrst = 1U << 26U;
inline constexpr std::uint32_t rcc_csr_porrst = 1U << 27U;
inline constexpr std::uint32_t rcc_csr_sftrst = 1U << 28U;
inline constexpr std::uint32_t rcc_csr_iwdgrst = 1U << 29U;
inline constexpr std::uint32_t rcc_csr_wwdgrst = 1U << 30U;
inline constexpr std::uint32_t rcc_csr_lpwrrst = 1U << 31U;

}  // namespace fantail::hal::stm32f4::registers
