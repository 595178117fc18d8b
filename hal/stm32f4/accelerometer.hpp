// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/accelerometer.hpp"
#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "hal/stm32f4/frozen_counts.hpp"
#include "hal/stm32f4/sensor_start.hpp"
#include "hal/stm32f4/spi_registers.hpp"

namespace fantail::hal::stm32f4 {

/// Kionix KX134-1211 at +-32 g, 1600 Hz. Why this one beside the IMU: another maker and another process, so that the
/// two do not share a weakness or a bad batch; a range above what a motor's burnout and a parachute's opening put on a
/// rocket, where the IMU's 16 g have ended, and still 1 mg to a count, so that it sees the 1 g of the pad; and it is
/// sold on small boards whose SPI pins are brought out.
///
/// As with the IMU nothing here waits: each read() carries the device's start on by one step. The low-pass of the
/// device (a ninth of its rate: 178 Hz) is below half of the 1 kHz it is read at.
///
/// Its mechanical self-test is not used: a status cannot name it, and the arming rules ask more of it than the 0.5 g
/// with its tolerance of 0.4 g could show, 1 g within 0.1 g beside the IMU's. That its logic came up whole is asked at
/// each reset (COTR).
class Accelerometer final : public hal::Accelerometer {
 public:
  /// The bus of the device and the clock outlive this object.
  Accelerometer(SpiDevice device, const hal::Clock& clock) : registers_{device}, clock_{clock} {}

  /// Before the first read(). Nothing is sent yet.
  void start(SensorStart how) { stage_ = how == SensorStart::in_flight ? Stage::adopt : Stage::reset; }
  /// Once a tick.
  AccelerometerSample read() override;
  [[nodiscard]] float scale() const override;
  /// What is wrong now.
  [[nodiscard]] BoardFaults faults() const;

  /// A sample that is found in the device is older than that: half a period on average, and 0.9 ms in the low-pass, if
  /// it is one of first order, which the manual does not say.
  static constexpr Microseconds age_when_found{1'200};

 private:
  enum class Stage : std::uint8_t { adopt, reset, wait_for_reset, running };

  void adopt(Microseconds now);
  void reset();
  void wait_for_reset(Microseconds now);
  void run(Microseconds now);
  void take(Microseconds now, const Counts& counts);
  void begin_running(Microseconds now);
  void restart();
  void miss();
  bool check_id(std::uint8_t id);

  SpiRegisters registers_;
  const hal::Clock& clock_;
  Stage stage_ = Stage::reset;
  bool silent_ = false;
  bool wrong_id_ = false;
  Microseconds reset_at_{};
  Microseconds last_new_{};
  std::uint8_t misses_ = 0;
  /// Its manual names no noise. These hold the false alarms below 1e-9 in an hour down to a quarter (one axis) and a
  /// third (three) of a count, which is 0.25 and 0.35 mg.
  FrozenCounts counts_{{.one_axis = 1'100, .three_axes = 110}};
  AccelerometerSample sample_{};
};

}  // namespace fantail::hal::stm32f4
