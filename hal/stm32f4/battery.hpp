// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/stm32f4/registers/adc.hpp"

namespace fantail::hal::stm32f4 {

/// The battery behind a divider at one channel of the converter. Each tick reads the conversion that the tick before
/// began, so nothing ever waits.
class Battery {
 public:
  struct Wiring {
    std::uint8_t channel;  ///< 10 to 18
    std::uint32_t reference_mv;
    std::uint32_t divider;  ///< battery to pin
  };

  Battery(registers::Adc& converter, registers::AdcCommon& common, const Wiring& wiring);

  /// Once a tick.
  void update();

  /// Empty until the first conversion, and while failed().
  [[nodiscard]] std::optional<std::uint16_t> millivolts() const { return millivolts_; }
  /// The converter has not answered for ten ticks.
  [[nodiscard]] bool failed() const { return ticks_without_ >= patience_ticks; }

 private:
  static constexpr std::uint32_t patience_ticks = 10;

  registers::Adc* converter_;
  Wiring wiring_;
  std::optional<std::uint16_t> millivolts_;
  std::uint32_t ticks_without_ = 0;
};

}  // namespace fantail::hal::stm32f4
