// SPDX-License-Identifier: MIT
#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::hal::stm32f4::registers {

void mask_interrupts() { __asm volatile("cpsid i" ::: "memory"); }

// Without the barrier a mask that follows at once may come before the interrupt: Armv7-M ARM, section B1.4.3.
void unmask_interrupts() { __asm volatile("cpsie i\n isb" ::: "memory"); }

void finish_stores() { __asm volatile("dsb" ::: "memory"); }

void synchronize() { __asm volatile("dsb\n isb" ::: "memory"); }

// On a multiple of 8, with three instructions behind it that do nothing: a probe leaves DBG_SLEEP set until the power
// goes, and then a WFI at an address that ends in 4 wakes up into wrong instructions. (Errata sheet ES0182, debugging
// sleep mode; that the instructions behind it alone do not help was found by apache/mynewt-core, pull request 2058.)
void wait_for_interrupt() { __asm volatile("dsb\n .balign 8\n wfi\n nop\n nop\n nop" ::: "memory"); }

}  // namespace fantail::hal::stm32f4::registers
