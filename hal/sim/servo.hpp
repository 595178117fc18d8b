// SPDX-License-Identifier: MIT
#pragma once

#include "hal/servo.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Servo final : public hal::Servo {
 public:
  explicit Servo(WorldSide& world) : world_{world} {}
  void write(const std::array<std::optional<Pulse>, canards>& pulses) override { world_.pulses = pulses; }

 private:
  WorldSide& world_;
};

}  // namespace fantail::hal::sim
