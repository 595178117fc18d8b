// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/stm32f4/registers/rcc.hpp"
#include "hal/stm32f4/registers/tim.hpp"

namespace fantail::hal::stm32f4 {

/// How fast the watchdog's oscillator is, which may be anything from 17 to 47 kHz: sixteen of its cycles, 0.3 to 0.9
/// ms, by TIM5, which counts `timer_hz`. Empty where it does not answer in time, or is faster or slower than that.
[[nodiscard]] std::optional<std::uint32_t> measure_slow_oscillator(registers::Rcc& rcc, registers::Tim& tim5,
                                                                   std::uint32_t timer_hz);

}  // namespace fantail::hal::stm32f4
