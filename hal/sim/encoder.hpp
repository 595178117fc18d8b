// SPDX-License-Identifier: MIT
#pragma once

#include "hal/encoder.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Encoder final : public hal::Encoder {
 public:
  explicit Encoder(const WorldSide& world) : world_{world} {}
  EncoderReading read() override { return world_.encoders; }

 private:
  const WorldSide& world_;
};

}  // namespace fantail::hal::sim
