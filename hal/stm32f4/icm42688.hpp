// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4::icm42688 {

// TDK InvenSense DS-000347 revision 1.8: register map in section 13, descriptions in 14 to 16.

/// Section 14.1: modes 0 and 3. Section 3.3: at most 24 MHz, selected 39 ns before the first edge.
inline constexpr SpiSettings spi{.mode = SpiMode::mode_0, .most_hz = 24'000'000, .select_ns = 39};

// Bank 0.
inline constexpr std::uint8_t device_config = 0x11;
inline constexpr std::uint8_t interrupt_config = 0x14;
inline constexpr std::uint8_t temperature_data = 0x1D;  ///< here begin temperature, accelerometer and gyro
inline constexpr std::uint8_t accelerometer_data = 0x1F;
inline constexpr std::uint8_t gyro_data = 0x25;
inline constexpr std::uint8_t interrupt_status = 0x2D;
inline constexpr std::uint8_t interface_config_0 = 0x4C;
inline constexpr std::uint8_t interface_config_1 = 0x4D;
inline constexpr std::uint8_t power_management_0 = 0x4E;
inline constexpr std::uint8_t gyro_config_0 = 0x4F;
inline constexpr std::uint8_t accelerometer_config_0 = 0x50;
inline constexpr std::uint8_t gyro_config_1 = 0x51;
inline constexpr std::uint8_t filter_config_0 = 0x52;  ///< GYRO_ACCEL_CONFIG0
inline constexpr std::uint8_t accelerometer_config_1 = 0x53;
inline constexpr std::uint8_t interrupt_config_0 = 0x63;
inline constexpr std::uint8_t interrupt_config_1 = 0x64;
inline constexpr std::uint8_t interrupt_source_0 = 0x65;
inline constexpr std::uint8_t self_test_config = 0x70;
inline constexpr std::uint8_t who_am_i = 0x75;
inline constexpr std::uint8_t bank_select = 0x76;  ///< in every bank
// Bank 1.
inline constexpr std::uint8_t gyro_config_static_3 = 0x0C;
inline constexpr std::uint8_t gyro_config_static_4 = 0x0D;
inline constexpr std::uint8_t gyro_config_static_5 = 0x0E;
inline constexpr std::uint8_t gyro_self_test_data = 0x5F;  ///< and y and z behind it
// Bank 2.
inline constexpr std::uint8_t accelerometer_config_static_2 = 0x03;
inline constexpr std::uint8_t accelerometer_config_static_3 = 0x04;
inline constexpr std::uint8_t accelerometer_config_static_4 = 0x05;
inline constexpr std::uint8_t accelerometer_self_test_data = 0x3B;

inline constexpr std::uint8_t id = 0x47;
inline constexpr std::uint8_t soft_reset = 0x01;      ///< DEVICE_CONFIG
inline constexpr std::uint8_t reset_done = 1U << 4U;  ///< INT_STATUS, cleared by reading it
inline constexpr std::uint8_t data_ready = 1U << 3U;  ///< INT_STATUS, cleared by reading it
inline constexpr std::uint8_t gyro_low_noise = 0x0C;  ///< PWR_MGMT0
inline constexpr std::uint8_t accelerometer_low_noise = 0x03;
inline constexpr std::uint8_t gyro_self_test = 0x07;           ///< SELF_TEST_CONFIG: all three axes
inline constexpr std::uint8_t accelerometer_self_test = 0x78;  ///< the same, with its supply

}  // namespace fantail::hal::stm32f4::icm42688
