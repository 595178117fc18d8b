// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// The processor's own timer. PM0214 section 4.5.
struct SysTick {
  Register ctrl;
  Register load;
  Register val;
  Register calib;
};
static_assert(offsetof(SysTick, val) == 0x08);

inline constexpr std::uint32_t systick_ctrl_enable = 1U << 0U;
inline constexpr std::uint32_t systick_ctrl_tickint = 1U << 1U;
inline constexpr std::uint32_t systick_ctrl_clksource = 1U << 2U;  ///< the processor's clock, not an eighth of it
inline constexpr std::uint32_t systick_load_most = 0xFFFFFF;

/// System control block. PM0214 section 4.4.
struct Scb {
  Register cpuid;
  Register icsr;
  Register vtor;
  Register aircr;
  Register scr;
  Register ccr;
  Register shpr[3];
  Register shcsr;
  Register cfsr;
  Register hfsr;
  Register dfsr;
  Register mmfar;
  Register bfar;
  Register afsr;
};
static_assert(offsetof(Scb, aircr) == 0x0C);
static_assert(offsetof(Scb, shpr) == 0x18);
static_assert(offsetof(Scb, cfsr) == 0x28);
static_assert(offsetof(Scb, bfar) == 0x38);

inline constexpr std::uint32_t scb_icsr_vectactive = 0x1FFU;        ///< which exception runs
inline constexpr std::uint32_t scb_icsr_pendstset = 1U << 26U;      ///< the SysTick interrupt is due and not yet served
inline constexpr std::uint32_t scb_aircr_vectkey = 0x05FAU << 16U;  ///< without it a write does nothing
inline constexpr std::uint32_t scb_aircr_sysresetreq = 1U << 2U;
inline constexpr std::uint32_t scb_shpr3_systick_shift = 24;

}  // namespace fantail::hal::stm32f4::registers
