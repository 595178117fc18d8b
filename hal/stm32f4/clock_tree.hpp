// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/board.hpp"
#include "hal/stm32f4/registers/flash_interface.hpp"
#include "hal/stm32f4/registers/pwr.hpp"
#include "hal/stm32f4/registers/rcc.hpp"

namespace fantail::hal::stm32f4 {

/// What runs how fast. The drivers are told; none of them knows these numbers by heart.
struct Frequencies {
  std::uint32_t core_hz = 0;
  std::uint32_t apb1_hz = 0;
  std::uint32_t apb1_timers_hz = 0;  ///< twice the bus when the bus is divided: RM0090 section 7.2
  std::uint32_t apb2_hz = 0;
  std::uint32_t apb2_timers_hz = 0;  ///< likewise
};

struct ClockTree {
  Frequencies frequencies{};
  BoardFaults faults{};
};

inline constexpr std::uint32_t crystal_hz = 8'000'000;
inline constexpr std::uint32_t internal_oscillator_hz = 16'000'000;  ///< HSI, within 1 %

/// 168 MHz from the crystal; where it does not start, from the internal oscillator (crystal_failed); where the PLL does
/// not lock, the internal oscillator's 16 MHz (clock_failed). Looks whether a supply that is too low for that resets
/// the processor (brown_out_level). Once, after a reset, when the processor runs on HSI.
///
/// A crystal that stops later raises the NMI (clock security system), which is a crash: by then the processor has
/// fallen back to 16 MHz, every divider in the drivers is wrong, and only a reset brings all of them to a clock that
/// is there.
[[nodiscard]] ClockTree start_clocks(registers::Rcc& rcc, registers::FlashInterface& flash, registers::Pwr& pwr);

/// The clocks of every peripheral that the board uses, save the backup memory; none answers before.
void enable_peripherals(registers::Rcc& rcc);

}  // namespace fantail::hal::stm32f4
