// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/contact.hpp"
#include "hal/debounced_contact.hpp"
#include "hal/stm32f4/pin.hpp"

namespace fantail::hal::stm32f4 {

/// What the pin reads while the contact is closed. The resistor pulls it to the other level, which is also that of a
/// wire that is off.
enum class ClosedLevel : std::uint8_t { high, low };

/// A contact between a pin and the supply (closed: high) or ground (closed: low).
class Contact final : public hal::Contact {
 public:
  Contact(Pin pin, ClosedLevel closed_level) : pin_{pin}, closed_is_high_{closed_level == ClosedLevel::high} {}

  /// Once a tick.
  void update() { contact_.update(pin_.is_high() == closed_is_high_); }
  [[nodiscard]] bool closed() const override { return contact_.closed(); }
  [[nodiscard]] bool open() const override { return contact_.open(); }

 private:
  Pin pin_;
  bool closed_is_high_;
  DebouncedContact contact_;
};

}  // namespace fantail::hal::stm32f4
