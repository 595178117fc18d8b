// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "board_in_world.hpp"

namespace fantail::board {

/// A virtual board in a simulated world whose supply comes and goes. Without it the board keeps nothing but the content
/// of its flash, where a page that was just being written is torn.
class SwitchedBoard final : public sim::FlightComputer {
 public:
  /// Off. The image and the ports outlive it. Throws text::Error when the image has no avionics in it.
  SwitchedBoard(const Image& image, std::vector<std::byte> flash, const sim::BoardPorts& ports);

  /// Nothing happens where it is so already.
  void switch_on();
  void switch_off();
  /// Null while it is off.
  [[nodiscard]] Board* board() { return powered_ ? &powered_->board() : nullptr; }

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return hardware_; }
  const core::TickRecord& tick() override;
  core::Microseconds restart(const sim::Reset& reset) override;

 private:
  const Image& image_;
  std::vector<std::byte> flash_;
  sim::BoardPorts ports_;
  hal::sim::WorldSide hardware_{};
  core::TickRecord record_{};
  std::unique_ptr<BoardInWorld> powered_;
};

}  // namespace fantail::board
