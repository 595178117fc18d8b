// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "avionics/avionics.hpp"
#include "core/flight_plan.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/devices.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::sim {

/// The avionics in this process, on simulated hardware.
class SimulatedBoard : public FlightComputer {
 public:
  /// `plan` has passed core::validate(); it is in force unless the flash holds another.
  SimulatedBoard(const core::FlightPlan& plan, const BoardPorts& ports, const avionics::Identity& identity = {});

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return devices_.world; }
  const core::TickRecord& tick() override {
    devices_.arm_switch.update();
    devices_.abort_contact.update();
    return avionics_->tick();
  }
  core::Microseconds restart(const Reset& reset) override;
  void flip_bit(MemoryPart part, std::uint64_t choice) override;

 private:
  void begin();

  core::FlightPlan plan_;
  BoardPorts ports_;
  avionics::Identity identity_;

 protected:
  hal::sim::Devices devices_;

 private:
  hal::sim::NoBackupMemory no_backup_memory_;
  hal::sim::BackupDomain backup_domain_{devices_.clock};

 protected:
  std::optional<avionics::Avionics> avionics_;  ///< never empty
};

}  // namespace fantail::sim
