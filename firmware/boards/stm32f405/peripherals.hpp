// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/stm32f4/registers/adc.hpp"
#include "hal/stm32f4/registers/can.hpp"
#include "hal/stm32f4/registers/dwt.hpp"
#include "hal/stm32f4/registers/exti.hpp"
#include "hal/stm32f4/registers/flash_interface.hpp"
#include "hal/stm32f4/registers/gpio.hpp"
#include "hal/stm32f4/registers/iwdg.hpp"
#include "hal/stm32f4/registers/mpu.hpp"
#include "hal/stm32f4/registers/nvic.hpp"
#include "hal/stm32f4/registers/pwr.hpp"
#include "hal/stm32f4/registers/rcc.hpp"
#include "hal/stm32f4/registers/rng.hpp"
#include "hal/stm32f4/registers/rtc.hpp"
#include "hal/stm32f4/registers/spi.hpp"
#include "hal/stm32f4/registers/systick.hpp"
#include "hal/stm32f4/registers/tim.hpp"
#include "hal/stm32f4/registers/usart.hpp"

namespace fantail::boards::stm32f405 {

namespace registers = hal::stm32f4::registers;

/// A block of registers at its address: RM0090 table 1, and PM0214 for the processor's own.
template <typename Block, std::uintptr_t address>
[[nodiscard]] Block& peripheral() {
  return *reinterpret_cast<Block*>(address);  // NOLINT(performance-no-int-to-ptr): that is where it is
}

inline registers::Tim& tim1() { return peripheral<registers::Tim, 0x40010000>(); }
inline registers::Tim& tim2() { return peripheral<registers::Tim, 0x40000000>(); }
inline registers::Tim& tim8() { return peripheral<registers::Tim, 0x40010400>(); }
inline registers::Tim& tim5() { return peripheral<registers::Tim, 0x40000C00>(); }
inline registers::Usart& usart1() { return peripheral<registers::Usart, 0x40011000>(); }
inline registers::Adc& adc1() { return peripheral<registers::Adc, 0x40012000>(); }
inline registers::AdcCommon& adc_common() { return peripheral<registers::AdcCommon, 0x40012300>(); }
inline registers::Exti& exti() { return peripheral<registers::Exti, 0x40013C00>(); }
inline registers::Spi& spi1() { return peripheral<registers::Spi, 0x40013000>(); }
inline registers::Spi& spi2() { return peripheral<registers::Spi, 0x40003800>(); }
inline registers::Spi& spi3() { return peripheral<registers::Spi, 0x40003C00>(); }
inline registers::Rtc& rtc() { return peripheral<registers::Rtc, 0x40002800>(); }
inline registers::Iwdg& iwdg() { return peripheral<registers::Iwdg, 0x40003000>(); }
inline registers::Can& can1() { return peripheral<registers::Can, 0x40006400>(); }
inline registers::Pwr& pwr() { return peripheral<registers::Pwr, 0x40007000>(); }
inline registers::Rcc& rcc() { return peripheral<registers::Rcc, 0x40023800>(); }
inline registers::FlashInterface& flash_interface() { return peripheral<registers::FlashInterface, 0x40023C00>(); }
inline registers::Rng& rng() { return peripheral<registers::Rng, 0x50060800>(); }
inline registers::Dwt& dwt() { return peripheral<registers::Dwt, 0xE0001000>(); }
inline registers::SysTick& systick() { return peripheral<registers::SysTick, 0xE000E010>(); }
inline registers::Nvic& nvic() { return peripheral<registers::Nvic, 0xE000E100>(); }
inline registers::Mpu& mpu() { return peripheral<registers::Mpu, 0xE000ED90>(); }
inline registers::Scb& scb() { return peripheral<registers::Scb, 0xE000ED00>(); }
inline registers::CoreDebug& core_debug() { return peripheral<registers::CoreDebug, 0xE000EDF0>(); }

/// Port 'A' to 'C'.
inline registers::Gpio& port(char name) {
  constexpr std::uintptr_t port_a = 0x40020000;
  constexpr std::uintptr_t port_size = 0x400;
  return *reinterpret_cast<registers::Gpio*>(  // NOLINT(performance-no-int-to-ptr)
      port_a + port_size * static_cast<std::uintptr_t>(name - 'A'));
}

/// The SRAM of the backup domain.
inline std::span<std::byte, 4096> backup_cells() {
  return std::span<std::byte, 4096>{&peripheral<std::byte, 0x40024000>(), 4096};
}

}  // namespace fantail::boards::stm32f405
