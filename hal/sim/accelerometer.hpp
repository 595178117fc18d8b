// SPDX-License-Identifier: MIT
#pragma once

#include "hal/accelerometer.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

class Accelerometer final : public hal::Accelerometer {
 public:
  explicit Accelerometer(const WorldSide& world) : world_{world} {}
  AccelerometerSample read() override { return world_.accelerometer; }
  [[nodiscard]] float scale() const override { return world_.accelerometer_scale_m_s2; }

 private:
  const WorldSide& world_;
};

}  // namespace fantail::hal::sim
