// SPDX-License-Identifier: MIT
#pragma once

#include "hal/arm_switch.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class ArmSwitch final : public hal::ArmSwitch {
 public:
  explicit ArmSwitch(const WorldSide& world) : world_{world} {}
  [[nodiscard]] bool closed() const override { return world_.arm_switch_closed; }

 private:
  const WorldSide& world_;
};

}  // namespace fantail::hal::sim
