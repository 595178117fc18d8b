// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/arm_switch.hpp"
#include "hal/stm32f4/pin.hpp"

namespace fantail::hal::stm32f4 {

/// A switch to the supply with a pull-down resistor. It changes when the pin has had the same new level for 50 ticks in
/// a row, both ways: contacts that chatter in the rumble of a motor do not disarm. Open at power-up, and where the wire
/// is off.
class ArmSwitch final : public hal::ArmSwitch {
 public:
  explicit ArmSwitch(Pin pin) : pin_{pin} {}

  /// Once a tick.
  void update() {
    ticks_of_change_ = pin_.is_high() == closed_ ? 0 : ticks_of_change_ + 1;
    if (ticks_of_change_ == ticks_to_change) {
      closed_ = !closed_;
      ticks_of_change_ = 0;
    }
  }
  [[nodiscard]] bool closed() const override { return closed_; }

 private:
  static constexpr std::uint32_t ticks_to_change = 50;

  Pin pin_;
  bool closed_ = false;
  std::uint32_t ticks_of_change_ = 0;
};

}  // namespace fantail::hal::stm32f4
