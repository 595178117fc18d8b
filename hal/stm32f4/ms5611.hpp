// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/clock.hpp"
#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::ms5611 {

// TE MS5611-01BA03: commands of one byte. Its data sheet was not available, only quotations from it.

/// It is specified for modes 0 and 3 and 20 MHz. PX4 reads wrong constants at 20 MHz from some devices (its pull
/// request 18790), and these are the settings of the accelerometer on the same bus, which then stays as it is.
inline constexpr SpiSettings spi{.mode = SpiMode::mode_0, .most_hz = 10'000'000, .select_ns = 50};

inline constexpr std::uint8_t reset = 0x1E;
inline constexpr std::uint8_t convert_pressure = 0x46;     ///< D1, oversampling 2048: noise 1.8 Pa
inline constexpr std::uint8_t convert_temperature = 0x56;  ///< D2, oversampling 2048: noise 0.003 degrees C
inline constexpr std::uint8_t read_result = 0x00;          ///< 24 bits, high byte first; zero: there is none
inline constexpr std::uint8_t read_constant = 0xA0;  ///< and twice the number of the word; 16 bits, high byte first

inline constexpr std::size_t constants = 8;  ///< the maker's own, C1 to C6, and one that ends with the CRC

inline constexpr Microseconds reset_time{2'800};
inline constexpr Microseconds typical_conversion{4'130};
inline constexpr Microseconds longest_conversion{4'540};

}  // namespace fantail::hal::stm32f4::ms5611
