// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "hal/stm32f4/registers/adc.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A successive-approximation converter with single conversions, RM0090 section 13.3: 12 bits after the sample time and
/// twelve cycles more.
struct FakeAdc {
  registers::Adc registers{};
  registers::AdcCommon common{};
  std::array<double, 19> volts{};  ///< at each channel
  double bus_hz = 84e6;
  bool ends = true;

  explicit FakeAdc(RegisterWorld& world) {
    world.on_write(registers.cr2, [this](std::uint32_t value) {
      if ((value >> 30U & 1U) != 0 && (value & 1U) != 0 && on_) {
        seconds_left_ = (cycles() + 12) / clock_hz();
      }
      on_ = (value & 1U) != 0;
    });
    world.on_read(registers.sr, [this] { return done_ ? 2U : 0U; });
    world.on_read(registers.dr, [this] {
      done_ = false;
      return data_;
    });
  }
  void pass(double seconds) {
    if (seconds_left_ > 0 && ends) {
      seconds_left_ -= seconds;
      if (seconds_left_ <= 0) {
        data_ =
            static_cast<std::uint32_t>(std::lround(volts[RegisterWorld::peek(registers.sqr[2]) & 31U] / 3.3 * 4095));
        done_ = true;
      }
    }
  }
  [[nodiscard]] double clock_hz() const { return bus_hz / (2 * ((RegisterWorld::peek(common.ccr) >> 16U & 3U) + 1)); }
  [[nodiscard]] double cycles() const {
    constexpr std::array<double, 8> choices{3, 15, 28, 56, 84, 112, 144, 480};
    return choices[RegisterWorld::peek(registers.smpr[0]) >> 6U & 7U];  // of channel 12
  }

 private:
  bool on_ = false;
  bool done_ = false;
  double seconds_left_ = 0;
  std::uint32_t data_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
