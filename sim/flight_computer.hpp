// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "avionics/identity.hpp"
#include "core/flight_plan.hpp"
#include "core/tick_record.hpp"
#include "hal/can_bus.hpp"
#include "hal/console.hpp"
#include "hal/entropy.hpp"
#include "hal/flash.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/fault.hpp"

namespace fantail::sim {

/// What the avionics has besides sensors and servos. They need not be simulated: a node on a PC has a real bus.
struct BoardPorts {
  hal::CanBus& can_bus;
  hal::Flash& flash;
  hal::Console& console;
  hal::Entropy& entropy;
  /// Memory that survives a reset. What is kept there costs every flight time, so only one with a reset has it.
  bool has_backup_memory = false;
};

enum class MemoryPart : std::uint8_t { flight_law, plan };

/// The avionics on its devices, wherever it runs: whoever plays the world fills hardware(), lets it have its tick, and
/// reads the servo pulses back from hardware().
class FlightComputer {
 public:
  virtual ~FlightComputer() = default;
  /// The same object at every call.
  [[nodiscard]] virtual hal::sim::WorldSide& hardware() = 0;
  /// The record is valid until the next tick.
  virtual const core::TickRecord& tick() = 0;
  /// The avionics begins anew after a reset; its last record is gone. hardware().time is the old clock's at this
  /// instant, and then the new one's, which is returned.
  virtual core::Microseconds restart(const Reset& reset) = 0;
  /// One bit flips, between two ticks. `choice`: any number; the bit is that one, counted around. Nothing happens in a
  /// computer whose memory cannot be reached from here.
  virtual void flip_bit(MemoryPart /*part*/, std::uint64_t /*choice*/) {}
};

/// Of what the world is given one to fly. `plan` has passed core::validate(); it is in force unless the flash holds
/// another. The ports outlive it. Of `identity` only what the world alone knows need count: where the avionics runs it
/// knows best what it is.
using MakeFlightComputer = std::function<std::unique_ptr<FlightComputer>(
    const core::FlightPlan& plan, const BoardPorts& ports, const avionics::Identity& identity)>;

/// In this process.
[[nodiscard]] std::unique_ptr<FlightComputer> simulated_board(const core::FlightPlan& plan, const BoardPorts& ports,
                                                              const avionics::Identity& identity);

}  // namespace fantail::sim
