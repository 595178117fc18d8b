// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/autopilot.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/scenario.hpp"

namespace fantail::benchmark {

/// What the avionics had before them in one tick.
struct RecordedTick {
  hal::sim::WorldSide hardware;
  core::Inputs inputs;  ///< the same as the autopilot sees it
  core::Phase phase;    ///< at the end of the tick
  core::Angle command;
};

/// A stretch of consecutive ticks.
struct Window {
  std::size_t begin;
  std::size_t end;
};

/// The simulated flight of tasha3_launch2, every tick of it from power-up on. Flown once, at the first use.
struct RecordedFlight {
  sim::Scenario scenario;
  std::vector<RecordedTick> ticks;

  /// Armed on the pad, at rest, with the gyro's bias being averaged.
  [[nodiscard]] Window armed() const;
  /// In control with the chirp on: the most that a tick has to do.
  [[nodiscard]] Window controlling_with_chirp() const;
};
[[nodiscard]] const RecordedFlight& recorded_flight();

}  // namespace fantail::benchmark
