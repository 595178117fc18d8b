// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"
#include "core/flight_plan.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/devices.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::sim {

/// The avionics in this process, on simulated hardware.
class SimulatedBoard final : public FlightComputer {
 public:
  /// `plan` has passed core::validate(); it is in force unless the flash holds another.
  SimulatedBoard(const core::FlightPlan& plan, const BoardPorts& ports, const avionics::Identity& identity = {})
      : avionics{{.clock = devices_.clock,
                  .imu = devices_.imu,
                  .accelerometer = devices_.accelerometer,
                  .servo = devices_.servo,
                  .encoder = devices_.encoder,
                  .arm_switch = devices_.arm_switch,
                  .can_bus = ports.can_bus,
                  .flash = ports.flash,
                  .console = ports.console,
                  .watchdog = devices_.watchdog,
                  .entropy = ports.entropy,
                  .board = devices_.board,
                  .backup_memory = backup_memory_},
                 plan,
                 identity} {}

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return devices_.world; }
  const core::TickRecord& tick() override { return avionics.tick(); }

 private:
  hal::sim::Devices devices_;
  hal::sim::NoBackupMemory backup_memory_;

 public:
  avionics::Avionics avionics;
};

}  // namespace fantail::sim
