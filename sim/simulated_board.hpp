// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"
#include "core/flight_plan.hpp"
#include "hal/sim/accelerometer.hpp"
#include "hal/sim/arm_switch.hpp"
#include "hal/sim/clock.hpp"
#include "hal/sim/encoder.hpp"
#include "hal/sim/imu.hpp"
#include "hal/sim/servo.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::sim {

/// The avionics on simulated hardware: whoever plays the world fills `hardware`, lets `avionics` have its tick, and
/// reads the servo pulses back from `hardware`.
class SimulatedBoard {
 public:
  /// `plan` has passed core::validate().
  explicit SimulatedBoard(const core::FlightPlan& plan)
      : avionics{{.clock = clock_,
                  .imu = imu_,
                  .accelerometer = accelerometer_,
                  .servo = servo_,
                  .encoder = encoder_,
                  .arm_switch = arm_switch_},
                 plan} {}
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

 public:
  avionics::Avionics avionics;
};

}  // namespace fantail::sim
