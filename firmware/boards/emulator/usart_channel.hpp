// SPDX-License-Identifier: MIT
#pragma once

#include "hal/emulator/channel.hpp"
#include "hal/stm32f4/console.hpp"

namespace fantail::boards::emulator {

/// The board's serial port as a way to the world.
class UsartChannel final : public hal::emulator::Channel {
 public:
  /// The port outlives this object.
  explicit UsartChannel(hal::stm32f4::Console& port) : port_{port} {}

  [[nodiscard]] std::size_t read(std::span<std::byte> out) override;
  /// A frame that is longer than the port's queue arrives damaged, and so is never understood: none is, save the frame
  /// of a tick in which the avionics sent more than fifty others on the bus.
  void write(std::span<const std::byte> bytes) override { port_.send(bytes); }

 private:
  hal::stm32f4::Console& port_;
};

}  // namespace fantail::boards::emulator
