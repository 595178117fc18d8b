// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "board_in_world.hpp"
#include "hal/emulator/channel.hpp"
#include "hal/emulator/console.hpp"
#include "hal/emulator/entropy.hpp"
#include "hal/emulator/stopwatch.hpp"
#include "hal/sim/can_bus.hpp"
#include "image_identity.hpp"
#include "protocol/hil_codec.hpp"
#include "world_link/flash.hpp"
#include "world_link/link.hpp"

namespace fantail::board {

/// A virtual board as the flight computer at the end of a link (protocol/hil_frame.hpp): a world in another program
/// asks, and the board answers with what its image has done in a millisecond.
class BoardServer {
 public:
  /// Image and channel outlive it.
  BoardServer(const Image& image, const Pace& pace, hal::emulator::Channel& channel);

  /// Answers the next question.
  void serve();

  /// Of the flight so far, empty before it has begun.
  [[nodiscard]] Board* board() { return flown_ ? &flown_->board() : nullptr; }
  /// All that its console has said.
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  void present();
  void begin(std::span<const std::byte> payload);
  void tick(std::span<const std::byte> payload);
  void refuse(std::string_view why);
  void exchange(protocol::HilReader& reader);

  /// Cycles of the board, where a real one has its own clock.
  struct Cycles final : hal::emulator::Stopwatch {
    std::uint32_t counts() override { return 0; }
  };

  const Image& image_;
  Pace pace_;
  ImageIdentity identity_;
  world_link::Link link_;
  Cycles cycles_;
  world_link::Flash flash_;
  hal::emulator::Console console_;
  hal::emulator::Entropy entropy_;
  hal::sim::CanWire wire_;
  hal::sim::CanBus boards_node_{wire_};
  hal::sim::CanBus worlds_node_{wire_};
  std::unique_ptr<BoardInWorld> flown_;
  std::string said_;
};

}  // namespace fantail::board
