// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"
#include "core/flight_plan.hpp"
#include "hal/can_bus.hpp"
#include "hal/console.hpp"
#include "hal/entropy.hpp"
#include "hal/flash.hpp"
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

namespace fantail::sim {

/// What the avionics has besides sensors and servos. They need not be simulated: a node on a PC has a real bus.
struct BoardPorts {
  hal::CanBus& can_bus;
  hal::Flash& flash;
  hal::Console& console;
  hal::Entropy& entropy;
};

/// The avionics on simulated hardware: whoever plays the world fills `hardware`, lets `avionics` have its tick, and
/// reads the servo pulses back from `hardware`.
class SimulatedBoard {
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

  hal::sim::WorldSide hardware;

 private:
  hal::sim::Clock clock_{hardware};
  hal::sim::Imu imu_{hardware};
  hal::sim::Accelerometer accelerometer_{hardware};
  hal::sim::Servo servo_{hardware};
  hal::sim::Encoder encoder_{hardware};
  hal::sim::ArmSwitch arm_switch_{hardware};
  hal::sim::Watchdog watchdog_{hardware};
  hal::sim::Board board_{hardware};
  hal::sim::NoBackupMemory backup_memory_;

 public:
  avionics::Avionics avionics;
};

}  // namespace fantail::sim
