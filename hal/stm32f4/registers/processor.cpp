// SPDX-License-Identifier: MIT
#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::hal::stm32f4::registers {

void mask_interrupts() { __asm volatile("cpsid i" ::: "memory"); }

// Without the barrier a mask that follows at once may come before the interrupt: Armv7-M ARM, section B1.4.3.
void unmask_interrupts() { __asm volatile("cpsie i\n isb" ::: "memory"); }

void finish_stores() { __asm volatile("dsb" ::: "memory"); }

void synchronize() { __asm volatile("dsb\n isb" ::: "memory"); }

void wait_for_interrupt() { __asm volatile("dsb\n wfi" ::: "memory"); }

}  // namespace fantail::hal::stm32f4::registers
