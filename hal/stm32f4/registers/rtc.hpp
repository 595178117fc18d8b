// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// Real-time clock. RM0090 section 26.6.
struct Rtc {
  Register tr;
  Register dr;
  Register cr;
  Register isr;
  Register prer;
  Register wutr;
  Register calibr;
  Register alrmar;
  Register alrmbr;
  Register wpr;
  Register ssr;
};
static_assert(offsetof(Rtc, prer) == 0x10);
static_assert(offsetof(Rtc, wpr) == 0x24);
static_assert(offsetof(Rtc, ssr) == 0x28);

// RTC_TR: time of day in decimal digits.
inline constexpr std::uint32_t rtc_tr_seconds_shift = 0;
inline constexpr std::uint32_t rtc_tr_minutes_shift = 8;
inline constexpr std::uint32_t rtc_tr_hours_shift = 16;
inline constexpr std::uint32_t rtc_tr_two_digits = 0x7F;
// RTC_CR.
inline constexpr std::uint32_t rtc_cr_bypshad = 1U << 5U;  ///< reads are of the counters, not of copies of them
// RTC_ISR.
inline constexpr std::uint32_t rtc_isr_initf = 1U << 6U;  ///< it stands still and may be set
inline constexpr std::uint32_t rtc_isr_init = 1U << 7U;   ///< asks for that
// RTC_PRER.
inline constexpr std::uint32_t rtc_prer_synchronous_shift = 0;
inline constexpr std::uint32_t rtc_prer_asynchronous_shift = 16;
// RTC_WPR: keys, not bits.
inline constexpr std::uint32_t rtc_wpr_first = 0xCA;
inline constexpr std::uint32_t rtc_wpr_second = 0x53;

}  // namespace fantail::hal::stm32f4::registers
