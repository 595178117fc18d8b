// SPDX-License-Identifier: MIT
#pragma once

#include "hal/sim/world_side.hpp"
#include "hal/watchdog.hpp"

namespace fantail::hal::sim {

class Watchdog final : public hal::Watchdog {
 public:
  explicit Watchdog(WorldSide& world) : world_{world} {}
  void feed() override { world_.watchdog_fed = world_.time; }

 private:
  WorldSide& world_;
};

}  // namespace fantail::hal::sim
