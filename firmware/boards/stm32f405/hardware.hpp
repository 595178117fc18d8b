// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"
#include "boards/stm32f405/peripherals.hpp"
#include "hal/board.hpp"
#include "hal/stm32f4/accelerometer.hpp"
#include "hal/stm32f4/backup_memory.hpp"
#include "hal/stm32f4/barometer.hpp"
#include "hal/stm32f4/battery.hpp"
#include "hal/stm32f4/board.hpp"
#include "hal/stm32f4/buzzer.hpp"
#include "hal/stm32f4/can_bus.hpp"
#include "hal/stm32f4/clock.hpp"
#include "hal/stm32f4/clock_tree.hpp"
#include "hal/stm32f4/console.hpp"
#include "hal/stm32f4/contact.hpp"
#include "hal/stm32f4/cycle_counter.hpp"
#include "hal/stm32f4/encoder.hpp"
#include "hal/stm32f4/entropy.hpp"
#include "hal/stm32f4/flash.hpp"
#include "hal/stm32f4/imu.hpp"
#include "hal/stm32f4/interrupt_line.hpp"
#include "hal/stm32f4/second_imu.hpp"
#include "hal/stm32f4/servo.hpp"
#include "hal/stm32f4/spi_bus.hpp"
#include "hal/stm32f4/supply.hpp"
#include "hal/stm32f4/watchdog.hpp"

namespace fantail::boards::stm32f405 {

/// Every device of the board, made in the order in which they need each other: clocks, pins, buses, drivers. One lives,
/// from the reset on.
class Hardware {
 public:
  Hardware();
  Hardware(const Hardware&) = delete;  // the drivers refer to each other
  Hardware& operator=(const Hardware&) = delete;

  [[nodiscard]] avionics::Devices devices();

  /// Looks for the sensors and the flash, joins the CAN bus, starts the watchdog, lets interrupts in. `how`: what the
  /// reset left of the sensors.
  void start(hal::stm32f4::SensorStart how);

  /// Waits until the next tick is due, and looks at what has to be looked at in each.
  void wait_for_tick();

  hal::stm32f4::Board& board() { return board_; }
  hal::stm32f4::Clock& clock() { return clock_; }
  hal::stm32f4::Console& console() { return console_; }
  hal::stm32f4::CanBus& can_bus() { return can_bus_; }
  hal::stm32f4::Servo& servo() { return servo_; }
  hal::stm32f4::BackupMemory& backup_memory() { return backup_memory_; }

 private:
  hal::ResetCause reset_cause_;
  hal::stm32f4::ClockTree tree_;
  hal::stm32f4::Watchdog watchdog_;
  hal::stm32f4::Clock clock_;
  hal::stm32f4::Console console_;
  hal::stm32f4::BackupMemory backup_memory_;
  hal::stm32f4::Supply supply_;
  hal::stm32f4::Entropy entropy_;
  hal::stm32f4::Battery battery_;
  hal::stm32f4::Buzzer buzzer_;
  hal::stm32f4::CycleCounter cycles_;
  hal::stm32f4::Board board_;
  hal::stm32f4::Contact arm_switch_;
  hal::stm32f4::Contact abort_contact_;
  hal::stm32f4::Servo servo_;
  hal::stm32f4::SpiBus imu_bus_;
  hal::stm32f4::SpiBus encoder_bus_;
  hal::stm32f4::SpiBus shared_bus_;
  hal::stm32f4::Imu imu_;
  hal::stm32f4::SecondImu second_imu_;
  hal::stm32f4::Accelerometer accelerometer_;
  hal::stm32f4::Barometer barometer_;
  hal::stm32f4::Encoder encoder_;
  hal::stm32f4::Flash flash_;
  hal::stm32f4::CanBus can_bus_;
};

/// For the interrupt handlers and the crash handler; empty before it was made.
[[nodiscard]] Hardware* running_hardware();

}  // namespace fantail::boards::stm32f405
