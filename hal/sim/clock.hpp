// SPDX-License-Identifier: MIT
#pragma once

#include "hal/clock.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Clock final : public hal::Clock {
 public:
  explicit Clock(const WorldSide& world) : world_{world} {}
  [[nodiscard]] Microseconds now() const override { return world_.time; }

 private:
  const WorldSide& world_;
};

}  // namespace fantail::hal::sim
