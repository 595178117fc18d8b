// SPDX-License-Identifier: MIT
#pragma once

#include "hal/board.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Board final : public hal::Board {
 public:
  explicit Board(WorldSide& world) : world_{world} {}
  [[nodiscard]] BoardStatus status() override { return world_.board; }
  void show(Signal signal) override { world_.shown = signal; }

 private:
  WorldSide& world_;
};

}  // namespace fantail::hal::sim
