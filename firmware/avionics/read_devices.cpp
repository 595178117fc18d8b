// SPDX-License-Identifier: MIT
#include "avionics/abort_input.hpp"
#include "avionics/avionics.hpp"

// What goes into a step of the flight law.
namespace fantail::avionics {

// One that the plan asks for and that is not there is silent.
std::optional<hal::ImuSample> Avionics::read_second_imu() {
  if (plan_.sensors.gyros == core::GyroRule::one) {
    return std::nullopt;
  }
  return devices_.second_imu ? turned(devices_.second_imu->read(), plan_.sensors.second_imu) : hal::ImuSample{};
}

// Each reading once. What it says that cannot be used is as good as silence: no log keeps it, and the flight law is not
// told.
std::optional<hal::BarometerSample> Avionics::read_barometer(core::Microseconds now) {
  if (plan_.sensors.barometer == core::BarometerUse::none || !devices_.barometer) {
    return std::nullopt;
  }
  const hal::BarometerSample sample = devices_.barometer->read();
  const bool is_new =
      sample.time > pressure_time_ && sample.time <= now && now - sample.time < protocol::oldest_pressure;
  if (sample.status != hal::Status::ok || sample.pressure_pa == 0 || !is_new) {
    return std::nullopt;
  }
  pressure_time_ = sample.time;
  return sample;
}

core::Inputs Avionics::read_devices(core::Microseconds now) {
  raw_ = {.imu = turned(devices_.imu.read(), plan_.sensors.imu),
          .second_imu = read_second_imu(),
          .accelerometer = turned(devices_.accelerometer.read(), plan_.sensors.accelerometer),
          .barometer = read_barometer(now),
          .encoders = devices_.encoder.read()};
  scales_ = {
      .imu = devices_.imu.scale(),
      .second_rate_rad_s = raw_.second_imu && devices_.second_imu ? devices_.second_imu->scale().rate_rad_s : 0.0F,
      .accelerometer_m_s2 = devices_.accelerometer.scale()};
  core::Inputs inputs = sensed(now, raw_, scales_, plan_.canards);
  inputs.arm_switch_closed = devices_.arm_switch.closed();
  inputs.arm_command = arming_.take_arm_command();
  inputs.start_command = arming_.take_start_command();
  inputs.abort = abort_state(plan_.run.abort_input, devices_.abort_contact) == protocol::AbortState::asks_to_abort;
  inputs.canard_request = bench_mode_.open() ? bench_mode_.canard_request(plan_.canards) : self_test_.canard_request();
  return inputs;
}

}  // namespace fantail::avionics
