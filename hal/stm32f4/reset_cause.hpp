// SPDX-License-Identifier: MIT
#pragma once

#include "hal/board.hpp"
#include "hal/stm32f4/registers/rcc.hpp"

namespace fantail::hal::stm32f4 {

/// Why the processor began anew; once, because it forgets the answer, so that the next reset finds only its own.
[[nodiscard]] ResetCause take_reset_cause(registers::Rcc& rcc);

}  // namespace fantail::hal::stm32f4
