// SPDX-License-Identifier: MIT
#pragma once

#include "hal/imu.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Imu final : public hal::Imu {
 public:
  explicit Imu(const WorldSide& world) : world_{world} {}
  ImuSample read() override { return world_.imu; }
  [[nodiscard]] ImuScale scale() const override { return world_.imu_scale; }

 private:
  const WorldSide& world_;
};

}  // namespace fantail::hal::sim
