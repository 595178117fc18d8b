// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/spi_registers.hpp"

namespace fantail::hal::stm32f4::icm42688 {

struct Setting {
  std::uint8_t bank;
  std::uint8_t address;
  std::uint8_t value;
};
// Both sensors are off while these are written (section 12.9). Reserved bits keep their reset values but for bits 7:6
// of INTF_CONFIG1: as 01 they switch off what else lets an axis of the gyro repeat itself for 1 to 2 ms whenever it
// passes 100 deg/s (ArduPilot, issue 25025; not in the data sheet).
inline constexpr auto settings = std::to_array<Setting>({
    {0, interface_config_0, 0x33},      // big-endian, -32768 until the first sample, no I2C
    {0, interface_config_1, 0x51},      // the gyro's oscillator as clock: 1 % instead of 8 % (section 4.10)
    {0, gyro_config_0, 0x06},           // 2000 deg/s, 1 kHz
    {0, accelerometer_config_0, 0x06},  // 16 g, 1 kHz
    {0, gyro_config_1, 0x16},           // second-order filter
    {0, filter_config_0, 0x00},         // 493 Hz (section 5.5)
    {0, accelerometer_config_1, 0x0D},  // second-order filter
    {0, interrupt_config_0, 0x00},      // data-ready is cleared by reading INT_STATUS
    // INT1: push-pull, active high, and a pulse, because a line that stays high until it is served would swallow the
    // edge of the second of two samples between two ticks. Section 12.6: without INT_ASYNC_RESET, or it does not work.
    {0, interrupt_config, 0x03},
    {0, interrupt_config_1, 0x00},  // of 100 us
    {0, interrupt_source_0, 0x08},  // data-ready alone
    // 258 Hz (section 5.3): delta 6, its square 36, shift 10.
    {1, gyro_config_static_3, 6},
    {1, gyro_config_static_4, 36},
    {1, gyro_config_static_5, 10U << 4U},
    {2, accelerometer_config_static_2, 6U << 1U},
    {2, accelerometer_config_static_3, 36},
    {2, accelerometer_config_static_4, 10U << 4U},
});
inline constexpr std::uint8_t both_on = gyro_low_noise | accelerometer_low_noise;

/// Ends in bank 0, where it begins; false when `visit` was for one of them.
template <typename Visit>
bool for_each_setting(SpiRegisters& registers, Visit visit) {
  std::uint8_t bank = 0;
  for (const Setting& setting : settings) {
    if (setting.bank != bank && !registers.write(bank_select, setting.bank)) {
      return false;
    }
    bank = setting.bank;
    if (!visit(setting)) {
      return false;
    }
  }
  return registers.write(bank_select, 0);
}

}  // namespace fantail::hal::stm32f4::icm42688
