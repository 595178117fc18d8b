// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::as5047p {

// ams AS5047P data sheet, sections "SPI Interface (slave)", "SPI Transaction" and "Volatile Registers".

/// CPOL = 0, CPHA = 1, at most 10 MHz, and 350 ns between chip select and the first edge (tL).
inline constexpr SpiSettings spi{.mode = SpiMode::mode_1, .most_hz = 10'000'000, .select_ns = 350};

// Frames of 16 bits. In a command bit 14 says "read"; in an answer it is the error flag: the frame before this one
// was not understood, or one before that and nobody has asked for ERRFL since. Bit 15 makes the number of ones even.
inline constexpr std::uint16_t read_bit = 1U << 14U;
inline constexpr std::uint16_t error_flag = 1U << 14U;
inline constexpr std::uint16_t parity_bit = 1U << 15U;
inline constexpr std::uint16_t data_mask = 0x3FFF;

inline constexpr std::uint16_t errors = 0x0001;     ///< ERRFL: framing, invalid command, parity; cleared by reading it
inline constexpr std::uint16_t diagnosis = 0x3FFC;  ///< DIAAGC
inline constexpr std::uint16_t angle = 0x3FFF;      ///< ANGLECOM: with the dynamic angle error compensated

// DIAAGC.
inline constexpr std::uint16_t field_too_low = 1U << 11U;
inline constexpr std::uint16_t field_too_high = 1U << 10U;
inline constexpr std::uint16_t cordic_overflow = 1U << 9U;
inline constexpr std::uint16_t offsets_ready = 1U << 8U;

[[nodiscard]] constexpr bool is_even(std::uint16_t frame) { return std::popcount(frame) % 2 == 0; }

[[nodiscard]] constexpr std::uint16_t read_command(std::uint16_t address) {
  const auto command = static_cast<std::uint16_t>(address | read_bit);
  return is_even(command) ? command : static_cast<std::uint16_t>(command | parity_bit);
}
static_assert(read_command(angle) == 0xFFFF);
static_assert(read_command(errors) == 0x4001);

}  // namespace fantail::hal::stm32f4::as5047p
