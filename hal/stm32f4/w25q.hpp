// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/clock.hpp"
#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::w25q {

// Winbond W25Q128JV revision F: status registers in section 7.1, instructions in 8.2, times in 9.6.

/// Section 8.1: modes 0 and 3. Section 9.6: 50 MHz for Read Data (03h), 133 MHz for all else.
inline constexpr SpiSettings spi{.mode = SpiMode::mode_0, .most_hz = 50'000'000, .select_ns = 5};

inline constexpr std::byte write_enable{0x06};
inline constexpr std::byte write_enable_for_volatile_status{0x50};
inline constexpr std::byte read_status_1{0x05};
inline constexpr std::byte read_status_2{0x35};
inline constexpr std::byte read_status_3{0x15};
inline constexpr std::byte write_status_1{0x01};
inline constexpr std::byte write_status_2{0x31};
inline constexpr std::byte write_status_3{0x11};
inline constexpr std::byte read_data{0x03};
inline constexpr std::byte page_program{0x02};
inline constexpr std::byte sector_erase{0x20};
inline constexpr std::byte release_power_down{0xAB};
inline constexpr std::byte jedec_id{0x9F};

// Status register 1.
inline constexpr std::uint8_t busy = 1U << 0U;
inline constexpr std::uint8_t write_enabled = 1U << 1U;
inline constexpr std::uint8_t block_protection = 0x7C;  ///< SEC, TB, BP2..0
// Status registers 2 and 3.
inline constexpr std::uint8_t complement_protection = 1U << 6U;   ///< CMP: what is not protected is
inline constexpr std::uint8_t individual_block_locks = 1U << 2U;  ///< WPS: and all are locked at power-up

// Section 9.6, at worst.
inline constexpr Microseconds longest_program{3'000};
inline constexpr Microseconds longest_erase{400'000};

inline constexpr std::uint8_t manufacturer = 0xEF;
inline constexpr std::uint8_t memory_type = 0x40;     ///< W25Q..JV-IQ, -JQ, -IN
inline constexpr std::uint8_t memory_type_m = 0x70;   ///< W25Q..JV-IM, -JM: with the same instructions
inline constexpr std::uint8_t least_capacity = 0x14;  ///< the size is 2 to the power of this: 1 MiB
inline constexpr std::uint8_t w25q128_capacity = 0x18;

}  // namespace fantail::hal::stm32f4::w25q
