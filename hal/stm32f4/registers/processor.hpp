// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::hal::stm32f4::registers {

// What the processor does by instruction and not by register. As load() and store(), these are replaced in the tests.

/// Interrupts wait from now on; an interrupt that waits still ends wait_for_interrupt().
void mask_interrupts();
/// Those that waited are served before this returns.
void unmask_interrupts();
/// Stops the processor until an interrupt comes.
void wait_for_interrupt();
/// What was written is where it was written to: before an interrupt returns.
void finish_stores();
/// What was written to the processor's own registers counts from here on.
void synchronize();

}  // namespace fantail::hal::stm32f4::registers
