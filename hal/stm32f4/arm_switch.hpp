// SPDX-License-Identifier: MIT
#pragma once

#include "hal/arm_switch.hpp"
#include "hal/debounced_contact.hpp"
#include "hal/stm32f4/pin.hpp"

namespace fantail::hal::stm32f4 {

/// A switch to the supply with a pull-down resistor: open where the wire is off.
class ArmSwitch final : public hal::ArmSwitch {
 public:
  explicit ArmSwitch(Pin pin) : pin_{pin} {}

  /// Once a tick.
  void update() { contact_.update(pin_.is_high()); }
  [[nodiscard]] bool closed() const override { return contact_.closed(); }
  [[nodiscard]] bool open() const override { return contact_.open(); }

 private:
  Pin pin_;
  DebouncedContact contact_;
};

}  // namespace fantail::hal::stm32f4
