// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "can_model.hpp"
#include "hal/stm32f4/can_bus.hpp"
#include "hal/stm32f4/registers/gpio.hpp"

namespace fantail::hal::stm32f4 {

inline constexpr std::uint32_t apb1_hz = 42'000'000;
inline constexpr std::array<std::uint16_t, 6> listens_to{0x010, 0x020, 0x030, 0x123, 0x400, 0x7FF};

/// The driver on its model, with a bus that is well and another node on it.
struct CanBusRig {
  test::RegisterWorld world{};
  registers::Can can{};
  registers::Gpio port{};
  registers::Register set_pending{};
  test::CanModel model{world, can};
  CanBus bus{can, Pin{port, 0}, InterruptLine{set_pending, 19}};

  CanBusRig() {
    model.connect({.transmit = [this] { bus.on_transmit_interrupt(); },
                   .receive = [this] { bus.on_receive_interrupt(); },
                   .error = [this] { bus.on_error_interrupt(); }},
                  set_pending);
  }

  [[nodiscard]] std::optional<BoardFault> start() { return bus.start(apb1_hz, listens_to); }
  [[nodiscard]] bool silent() const { return test::RegisterWorld::peek(port.bsrr) == 1U; }
};

/// A frame that is known by its number.
inline CanFrame numbered(std::uint32_t number, std::uint32_t id = 0x123) {
  CanFrame frame{.id = id, .length = 8};
  for (std::size_t i = 0; i < 8; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(i < 4 ? number >> 8 * i & 0xFFU : 0x10U * i);
  }
  return frame;
}
inline std::uint32_t number_of(const CanFrame& frame) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= static_cast<std::uint32_t>(frame.data[i]) << 8 * i;
  }
  return number;
}

}  // namespace fantail::hal::stm32f4
