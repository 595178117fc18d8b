// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::ism330dhcx {

// ST ISM330DHCX: registers, their bits and the counts' sizes as in ST's own driver (ism330dhcx-pid 4.1.0,
// ism330dhcx_reg.h and .c); what each setting means, and the filter's bandwidths (data sheet DS13012, table 58), as
// quoted by the I2Cdev library's ISM330DHCX.h. The data sheet itself could not be read.

/// Clock idle high; at most 10 MHz. The time before the first edge is not quoted anywhere: that of the KX134.
inline constexpr SpiSettings spi{.mode = SpiMode::mode_3, .most_hz = 10'000'000, .select_ns = 50};

inline constexpr std::uint8_t access = 0x01;  ///< FUNC_CFG_ACCESS: zero shows the registers below
inline constexpr std::uint8_t who_am_i = 0x0F;
inline constexpr std::uint8_t accelerometer_control = 0x10;  ///< CTRL1_XL: rate, range, second filter
inline constexpr std::uint8_t gyro_control = 0x11;           ///< CTRL2_G: rate, range
inline constexpr std::uint8_t control_3 = 0x12;              ///< CTRL3_C
inline constexpr std::uint8_t control_4 = 0x13;
inline constexpr std::uint8_t self_test_control = 0x14;     ///< CTRL5_C
inline constexpr std::uint8_t gyro_filter = 0x15;           ///< CTRL6_C
inline constexpr std::uint8_t accelerometer_filter = 0x17;  ///< CTRL8_XL
inline constexpr std::uint8_t control_9 = 0x18;             ///< CTRL9_XL
inline constexpr std::uint8_t status = 0x1E;  ///< then temperature, gyro and accelerometer, low byte first

inline constexpr std::uint8_t id = 0x6B;
inline constexpr std::uint8_t soft_reset = 0x01;       ///< CTRL3_C, cleared by itself
inline constexpr std::uint8_t addresses_go_on = 0x04;  ///< CTRL3_C, IF_INC: so after a reset
inline constexpr std::uint8_t whole_samples = 0x40;    ///< CTRL3_C, BDU: no sample half read is replaced
inline constexpr std::uint8_t configured = 0xE2;       ///< CTRL9_XL: DEVICE_CONF beside what a reset leaves
inline constexpr std::uint8_t gyro_self_test = 0x04;   ///< CTRL5_C
inline constexpr std::uint8_t gyro_ready = 0x02;       ///< STATUS_REG, cleared by reading the rates

}  // namespace fantail::hal::stm32f4::ism330dhcx
