// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "device_fault.hpp"
#include "pin_watch.hpp"
#include "sim/scenario.hpp"
#include "tick_meter.hpp"

namespace fantail::board {

/// What came of a device that fails.
struct DeviceTrial {
  bool came_to_an_end = false;
  core::Phase phase{};                ///< at the end
  core::PhaseReason reason{};         ///< of it
  double longest_tick_us = 0.0;       ///< from the fault on
  int ticks_missing = 0;              ///< of those that were due, from the first one on
  int restarts = 0;                   ///< from the fault on
  Pins pins{};                        ///< likewise
  double roll_deg = 0.0;              ///< the farthest from the flight without it
  std::array<char, 160> named{};      ///< faults on bus and console, verdicts, votes
  std::array<char, 160> refusal{};    ///< why it was not armed
  std::array<char, 160> complaint{};  ///< the processor's last
};

/// From power-up on with the fault, until it is armed or refused, or until neither comes.
[[nodiscard]] DeviceTrial boot_with(const Image& image, const sim::Scenario& scenario, const DeviceFault& fault);

/// A flight under control, and what measures it.
struct ControlledFlight {
  /// Flies until half a second of control is over. Throws std::runtime_error when there is none.
  ControlledFlight(const Image& image, const sim::Scenario& scenario);

  const sim::Scenario& scenario;
  BoardFlight flight;
  TickMeter meter;
  BoardWires wires;
  std::array<float, 1500> roll_deg{};  ///< of the next milliseconds without a fault
};

/// From now on with the fault, in a process of its own.
[[nodiscard]] DeviceTrial fly_with(ControlledFlight& flown, const DeviceFault& fault);

}  // namespace fantail::board
