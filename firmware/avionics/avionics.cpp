// SPDX-License-Identifier: MIT
#include "avionics/avionics.hpp"

#include <utility>

#include "avionics/sensor_scaling.hpp"

namespace fantail::avionics {

Avionics::Avionics(Devices devices, const core::FlightPlan& plan)
    : devices_{devices}, canards_{plan.canards}, autopilot_{plan} {}

const core::TickRecord& Avionics::tick() {
  const core::TickRecord& record = autopilot_.step(read_devices());
  devices_.servo.write(pulses(record.canards));
  return record;
}

core::Inputs Avionics::read_devices() {
  const hal::ImuSample imu = devices_.imu.read();
  const hal::ImuScale imu_scale = devices_.imu.scale();
  const hal::AccelerometerSample second = devices_.accelerometer.read();
  return {
      .time = devices_.clock.now(),
      .gyro = gyro_sample(imu, imu_scale),
      .accelerometers = {accelerometer_sample(imu.time, imu.specific_force, imu.status, imu_scale.specific_force_m_s2),
                         accelerometer_sample(second.time, second.specific_force, second.status,
                                              devices_.accelerometer.scale())},
      .encoders = encoder_angles(devices_.encoder.read(), canards_),
      .arm_switch_closed = devices_.arm_switch.closed(),
      .arm_command = std::exchange(arm_command_, false),
      .start_command = std::exchange(start_command_, false),
  };
}

}  // namespace fantail::avionics
