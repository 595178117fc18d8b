// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/clock.hpp"
#include "hal/imu.hpp"
#include "hal/stm32f4/sensor_start.hpp"
#include "hal/stm32f4/spi_registers.hpp"

namespace fantail::hal::stm32f4 {

/// ST ISM330DHCX: gyro +-4000 deg/s, accelerometer +-16 g, both at 3.3 kHz. Why this one beside the ICM-42688-P:
/// another maker and another process, so that the two do not share a weakness or a bad batch; twice its range of rates,
/// so that it goes on measuring where the first has come to its end; an industrial part; and it is sold on boards whose
/// SPI pins are brought out.
///
/// Nothing here waits, as with the IMU: each read() carries reset, self-test and start-up on by one step. There may be
/// none: then it says no_reading, and looks for one every 20 ms. At power-up the first sample comes 0.4 s after
/// start(), most of it self-test; from a device that never stopped, at the second read(). What is wrong with it has no
/// name among the board's faults, because a plan that asks for one gyro does not ask for this one: the pad's self-test
/// names it where the plan asks for two.
///
/// Filter: 292 Hz, which like the first one's 258 Hz keeps what vibrates above 500 Hz out of samples at 1 kHz.
class SecondImu final : public hal::Imu {
 public:
  /// The bus of the device and the clock outlive this object.
  SecondImu(SpiDevice device, const hal::Clock& clock) : registers_{device}, clock_{clock} {}

  /// Before the first read(). Nothing is sent yet.
  void start(SensorStart how);
  /// Once a tick.
  ImuSample read() override;
  [[nodiscard]] ImuScale scale() const override;

  /// A sample that is found in the device is older than that: half a period of 0.3 ms since it was put there, and the
  /// filter's delay, 0.77 ms if it is of second order (its order could not be read).
  static constexpr Microseconds age_when_found{920};

 private:
  enum class Stage : std::uint8_t { adopt, reset, wait_for_reset, at_rest, actuated, warm_up, running };
  using Sums = std::array<std::int32_t, 3>;

  void adopt(Microseconds now);
  void reset();
  void wait_for_reset(Microseconds now);
  void begin(Microseconds now, Stage stage);
  void carry_on_self_test(Microseconds now);
  bool configure();
  bool is_configured();
  void run(Microseconds now);
  void take(Microseconds now, std::span<const std::byte> burst);
  void miss(Status status);
  void restart(Status status);

  SpiRegisters registers_;
  const hal::Clock& clock_;
  Stage stage_ = Stage::reset;
  bool tested_ = false;  ///< or needs no test
  std::uint8_t samples_ = 0;
  std::uint8_t misses_ = 0;
  std::uint8_t repeats_ = 0;
  Microseconds since_{};     ///< of the stage
  Microseconds last_new_{};  ///< when a new sample was found last
  Sums sum_{};               ///< of the self-test
  Sums at_rest_{};
  ImuSample sample_{};
};

}  // namespace fantail::hal::stm32f4
