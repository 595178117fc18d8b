// SPDX-License-Identifier: MIT
#pragma once

#include "core/autopilot.hpp"
#include "core/flight_plan.hpp"
#include "hal/accelerometer.hpp"
#include "hal/arm_switch.hpp"
#include "hal/clock.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "hal/servo.hpp"

namespace fantail::avionics {

/// The devices of one rocket, whichever backend they come from.
struct Devices {
  hal::Clock& clock;
  hal::Imu& imu;
  hal::Accelerometer& accelerometer;
  hal::Servo& servo;
  hal::Encoder& encoder;
  hal::ArmSwitch& arm_switch;
};

/// The application: reads the hardware layer, steps the autopilot, writes the hardware layer. A board's or a world's
/// main calls tick() every millisecond and does nothing else.
class Avionics {
 public:
  /// `plan` has passed core::validate(); the devices outlive this object.
  Avionics(Devices devices, const core::FlightPlan& plan);

  /// One control tick. The record is valid until the next one.
  const core::TickRecord& tick();

  /// The second of the two independent actions that arm; the first is the arm switch. Acts in the next tick.
  void command_arm() { arm_command_ = true; }

  /// Tunnel plans: begin control in the next tick, if the rocket is at rest.
  void command_start() { start_command_ = true; }

 private:
  [[nodiscard]] core::Inputs read_devices();

  Devices devices_;
  core::CanardsPlan canards_;
  core::Autopilot autopilot_;
  bool arm_command_ = false;
  bool start_command_ = false;
};

}  // namespace fantail::avionics
