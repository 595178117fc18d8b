// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/stm32f4/registers/iwdg.hpp"
#include "hal/watchdog.hpp"

namespace fantail::hal::stm32f4 {

/// The independent watchdog, on an oscillator of its own: 50 ms, by what was measured of that oscillator. Where nothing
/// was, 50 ms at 32 kHz, which are between 34 ms and 94 ms over the 17 kHz to 47 kHz that the data sheet allows it.
class Watchdog final : public hal::Watchdog {
 public:
  explicit Watchdog(registers::Iwdg& device) : device_{&device} {}

  /// From here on it runs, and nothing stops it but a reset. False where it did not take the 50 ms in time: then it
  /// runs with the 512 ms it has from the reset.
  bool start(std::optional<std::uint32_t> oscillator_hz);
  void feed() override { device_->kr.write(registers::iwdg_kr_reload); }

 private:
  registers::Iwdg* device_;
};

}  // namespace fantail::hal::stm32f4
