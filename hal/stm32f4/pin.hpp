// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/gpio.hpp"

namespace fantail::hal::stm32f4 {

/// One pin of a port, as a driver sees it. The port outlives it. Its mode was set with the pin map, before any driver.
class Pin {
 public:
  Pin(registers::Gpio& port, std::uint8_t number) : port_{&port}, mask_{1U << number} {}

  void high() { port_->bsrr.write(mask_); }
  void low() { port_->bsrr.write(mask_ << 16U); }
  void set(bool level) { level ? high() : low(); }
  [[nodiscard]] bool is_high() const { return port_->idr.any(mask_); }

 private:
  registers::Gpio* port_;
  std::uint32_t mask_;
};

}  // namespace fantail::hal::stm32f4
