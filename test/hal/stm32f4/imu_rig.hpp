// SPDX-License-Identifier: MIT
#pragma once

#include "fake_capture.hpp"
#include "fake_icm42688.hpp"
#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu.hpp"
#include "sensor_rig.hpp"

namespace fantail::hal::stm32f4::test {

/// An IMU with its data-ready line at a timer.
class ImuRig : public SensorTest<FakeIcm42688, 84'000'000> {
 protected:
  static constexpr double timer_hz = 84e6;

  /// What is at the pin; as wired, INT1.
  FakeCapture::Line line = [this] { return device.interrupt_1(); };
  FakeCapture capture{world, clock, timer_hz, [this] { return line(); }};

  void be_free_of_noise() { device.gyro_noise_deg_s = device.accelerometer_noise_g = 0.0; }
  Imu make() {
    return Imu{place(icm42688::spi), clock, EdgeTimer{capture.registers, static_cast<std::uint32_t>(timer_hz)}};
  }
  /// The start without a self-test.
  Imu running() {
    Imu imu = make();
    imu.start(SensorStart::in_flight);
    EXPECT_LE(ticks_to_sample(imu, 100), 60);
    return imu;
  }
  void read_for(Imu& imu, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      static_cast<void>(next(imu));
    }
  }
};

}  // namespace fantail::hal::stm32f4::test
