// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// RM0090 section 30.6.
struct Usart {
  Register sr;
  Register dr;
  Register brr;
  Register cr1;
  Register cr2;
  Register cr3;
  Register gtpr;
};
static_assert(offsetof(Usart, brr) == 0x08);
static_assert(offsetof(Usart, gtpr) == 0x18);

// Section 30.6.1.
inline constexpr std::uint32_t usart_sr_pe = 1U << 0U;
inline constexpr std::uint32_t usart_sr_fe = 1U << 1U;
inline constexpr std::uint32_t usart_sr_ne = 1U << 2U;
inline constexpr std::uint32_t usart_sr_ore = 1U << 3U;  ///< cleared by reading SR and then DR, as the three above
inline constexpr std::uint32_t usart_sr_rxne = 1U << 5U;
inline constexpr std::uint32_t usart_sr_txe = 1U << 7U;
// Section 30.6.4.
inline constexpr std::uint32_t usart_cr1_re = 1U << 2U;
inline constexpr std::uint32_t usart_cr1_te = 1U << 3U;
inline constexpr std::uint32_t usart_cr1_rxneie = 1U << 5U;  ///< interrupts at RXNE and at ORE
inline constexpr std::uint32_t usart_cr1_txeie = 1U << 7U;
inline constexpr std::uint32_t usart_cr1_ue = 1U << 13U;

}  // namespace fantail::hal::stm32f4::registers
