// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "avionics/avionics.hpp"
#include "boards/emulator/measured.hpp"
#include "hal/emulator/channel.hpp"
#include "hal/emulator/console.hpp"
#include "hal/emulator/entropy.hpp"
#include "hal/emulator/stopwatch.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/devices.hpp"
#include "protocol/hil_codec.hpp"
#include "world_link/exchange.hpp"
#include "world_link/flash.hpp"
#include "world_link/link.hpp"

namespace fantail::boards::emulator {

/// The avionics behind a link: a world says when a tick is and what the devices show in it.
class Target {
 public:
  /// Channel and stopwatch outlive this object. `name` is that of the image.
  Target(hal::emulator::Channel& channel, hal::emulator::Stopwatch& stopwatch, std::string_view name,
         const Measured& measured);

  /// Answers the next question. `late`: milliseconds that have passed without one being answered.
  void serve(std::uint32_t late);

 private:
  void present();
  void begin(std::span<const std::byte> payload);
  void tick(std::span<const std::byte> payload);
  void refuse(std::string_view why);
  void take_frames(protocol::HilReader& reader);
  void give_frames(protocol::HilWriter& writer);

  hal::emulator::Stopwatch& stopwatch_;
  std::string_view name_;
  const Measured& measured_;
  world_link::Link link_;
  hal::sim::Devices devices_;
  hal::sim::NoBackupMemory backup_memory_;
  hal::sim::CanWire wire_;
  std::optional<hal::sim::CanBus> can_bus_;    ///< the avionics' node, new with every beginning
  std::optional<hal::sim::CanBus> world_bus_;  ///< all other nodes
  world_link::Flash flash_;
  hal::emulator::Console console_;
  hal::emulator::Entropy entropy_;
  std::array<char, 32> vehicle_{};
  std::array<char, 32> sensors_{};
  std::optional<avionics::Avionics> avionics_;
  bool ticked_ = false;
  std::uint32_t overruns_ = 0;
};

}  // namespace fantail::boards::emulator
