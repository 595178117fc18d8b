// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"
#include "core/flight_plan.hpp"
#include "hal/sim/accelerometer.hpp"
#include "hal/sim/arm_switch.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/board.hpp"
#include "hal/sim/clock.hpp"
#include "hal/sim/encoder.hpp"
#include "hal/sim/imu.hpp"
#include "hal/sim/servo.hpp"
#include "hal/sim/watchdog.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::sim {

/// The avionics in this process, on simulated hardware.
class SimulatedBoard final : public FlightComputer {
 public:
  /// `plan` has passed core::validate(); it is in force unless the flash holds another.
  SimulatedBoard(const core::FlightPlan& plan, const BoardPorts& ports, const avionics::Identity& identity = {})
      : avionics{{.clock = clock_,
                  .imu = imu_,
                  .accelerometer = accelerometer_,
                  .servo = servo_,
                  .encoder = encoder_,
                  .arm_switch = arm_switch_,
                  .can_bus = ports.can_bus,
                  .flash = ports.flash,
                  .console = ports.console,
                  .watchdog = watchdog_,
                  .entropy = ports.entropy,
                  .board = board_,
                  .backup_memory = backup_memory_},
                 plan,
                 identity} {}
  SimulatedBoard(const SimulatedBoard&) = delete;  // the devices point into it
  SimulatedBoard& operator=(const SimulatedBoard&) = delete;

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return hardware_; }
  const core::TickRecord& tick() override { return avionics.tick(); }

 private:
  hal::sim::WorldSide hardware_;
  hal::sim::Clock clock_{hardware_};
  hal::sim::Imu imu_{hardware_};
  hal::sim::Accelerometer accelerometer_{hardware_};
  hal::sim::Servo servo_{hardware_};
  hal::sim::Encoder encoder_{hardware_};
  hal::sim::ArmSwitch arm_switch_{hardware_};
  hal::sim::Watchdog watchdog_{hardware_};
  hal::sim::Board board_{hardware_};
  hal::sim::NoBackupMemory backup_memory_;

 public:
  avionics::Avionics avionics;
};

}  // namespace fantail::sim
