// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::kx134 {

// Kionix KX134-1211 Technical Reference Manual revision 1.0, section 1: embedded registers.

/// Specifications revision 1.0: SPI mode 0, at most 10 MHz.
inline constexpr SpiSettings spi{.mode = SpiMode::mode_0, .most_hz = 10'000'000, .select_ns = 50};

inline constexpr std::uint8_t output = 0x08;                 ///< XOUT_L: x, y, z, low byte first
inline constexpr std::uint8_t command_test_response = 0x12;  ///< COTR
inline constexpr std::uint8_t who_am_i = 0x13;
inline constexpr std::uint8_t interrupt_source_2 = 0x17;
inline constexpr std::uint8_t control_1 = 0x1B;
inline constexpr std::uint8_t control_2 = 0x1C;
inline constexpr std::uint8_t output_rate = 0x21;  ///< ODCNTL
inline constexpr std::uint8_t unnamed = 0x7F;      ///< the power-on procedure (TN027) writes a zero into it

inline constexpr std::uint8_t id = 0x46;
inline constexpr std::uint8_t test_response = 0x55;   ///< what COTR holds after a reset
inline constexpr std::uint8_t data_ready = 1U << 4U;  ///< INS2, cleared by reading the output
inline constexpr std::uint8_t soft_reset = 1U << 7U;  ///< CNTL2

}  // namespace fantail::hal::stm32f4::kx134
