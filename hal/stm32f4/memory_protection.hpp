// SPDX-License-Identifier: MIT
#pragma once

#include "hal/stm32f4/registers/mpu.hpp"

namespace fantail::hal::stm32f4 {

/// Switches on the memory protection unit:
/// - below the flash nothing may be read or written. What would be found there is the flash a second time, so that a
///   null pointer would read the vector table as data and nobody would notice. Now it is a crash. (The processor
///   fetches vectors past the unit.)
/// - the 8 kB below the stack, which lies at the bottom of the RAM, likewise. RM0090 calls them reserved and does not
/// say
///   what becomes of a write; now a stack that overflows is a crash, before it has written anything. No function's
///   frame is as large as this, so none reaches past it.
/// - the backup memory is ordinary memory, without a cache. By its address it would be a device, of which an access
/// that
///   is not aligned to its size is unpredictable (Armv7-M A3.2.1), and the state of a flight lies there byte by byte.
void protect_memory(registers::Mpu& mpu);

}  // namespace fantail::hal::stm32f4
