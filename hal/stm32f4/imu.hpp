// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "hal/imu.hpp"
#include "hal/stm32f4/edge_timer.hpp"
#include "hal/stm32f4/frozen_counts.hpp"
#include "hal/stm32f4/imu_self_test.hpp"
#include "hal/stm32f4/sample_edges.hpp"
#include "hal/stm32f4/sensor_start.hpp"
#include "hal/stm32f4/spi_registers.hpp"

namespace fantail::hal::stm32f4 {

/// ICM-42688-P: gyro +-2000 deg/s, accelerometer +-16 g, both at 1 kHz in low-noise mode.
///
/// Nothing here waits. Reset, self-test and start-up of the device are steps of one machine that each read() carries on
/// by one, so a device that has to be set up again in flight costs its own samples and nobody's tick. Until it delivers
/// a status says so. At power-up the first sample comes about 1.2 s after start(), most of it self-test; without one
/// after 50 ms; from a device that never stopped, at the second read().
///
/// Filters: the anti-alias filter at 258 Hz, before the data is thinned out to 1 kHz, where a motor's vibration above
/// 500 Hz would otherwise come back as slow motion; the filter behind it as wide as 1 kHz allows (493 Hz), because each
/// millisecond of delay is phase lost to the roll loop. Together they delay by 1.6 ms: at 3 Hz less than 2 degrees.
///
/// Time: the device samples by its own clock, up to some percent off, and gives a pulse at its INT1 with each sample.
/// The edge before the one that is read says when that was, to a microsecond. (Its FIFO with time stamps would say the
/// same with more bytes, and in the device's own time.) Where the edges do not fit the samples, the wire is off or
/// something else drives it: then a sample is taken to be half a millisecond old when it is found, and a fault says so.
///
/// Disturbances on its wires: the device adds no checksum, so the counts are read twice, and taken when both are the
/// same.
///
/// Counts that repeat: see FrozenCounts. A gyro that is frozen is not used, and the device is set up again; of an
/// accelerometer that is frozen only its own counts are not used, because a restart would cost the gyro.
class Imu final : public hal::Imu {
 public:
  /// The bus of the device and the clock outlive this object.
  Imu(SpiDevice device, const hal::Clock& clock, EdgeTimer data_ready)
      : registers_{device}, clock_{clock}, data_ready_{data_ready} {}

  /// Before the first read(). Nothing is sent yet.
  void start(SensorStart how);
  /// Once a tick.
  ImuSample read() override;
  [[nodiscard]] ImuScale scale() const override;
  /// What is wrong now; a failed self-test stays until power-up.
  [[nodiscard]] BoardFaults faults() const;

  /// From what is measured to its edge (DS-000347 section 5.5: 0.7 ms; a second-order filter at 258 Hz: 0.87 ms).
  static constexpr Microseconds filter_delay{1'570};
  /// A sample without an edge was put there half a millisecond ago on average.
  static constexpr Microseconds age_when_found{filter_delay + Microseconds{500}};

 private:
  enum class Stage : std::uint8_t { adopt, reset, wait_for_reset, self_test, warm_up, running };

  /// In one tick.
  struct Readings {
    std::array<std::byte, 17> burst{};  ///< from the temperature to INT_STATUS
    std::array<std::byte, 12> again{};  ///< both sensors
  };
  /// Of the data-ready line; `others`: more than one came since a tick ago.
  struct LatestEdge {
    EdgeTimer::Edge count;
    Microseconds time;
    bool others;
  };

  void adopt(Microseconds now);
  void reset();
  void wait_for_reset(Microseconds now);
  void carry_on_self_test(Microseconds now);
  void begin_running(Microseconds now);
  bool configure();
  bool is_configured();
  void run(Microseconds now);
  bool read_twice(Readings& readings);
  void take(Microseconds now, const Readings& readings, const LatestEdge& edge);
  void judge_counts();
  void restart();
  /// Is it the device that belongs here? Remembers what is wrong.
  bool check_id(std::uint8_t id);
  void settle_for(Microseconds now, Microseconds duration);

  SpiRegisters registers_;
  const hal::Clock& clock_;
  EdgeTimer data_ready_;
  Stage stage_ = Stage::reset;
  ImuSelfTest self_test_{};
  std::uint8_t self_tests_left_ = 0;
  bool silent_ = false;
  bool wrong_id_ = false;
  bool self_test_failed_ = false;
  Microseconds stage_ends_{};
  Microseconds last_new_{};  ///< when a new sample was found last
  std::uint8_t misses_ = 0;  ///< reads without an answer, one after the other
  std::array<std::byte, 12> last_data_{};
  SampleEdges edges_{};
  FrozenCounts gyro_{{.one_axis = 200, .three_axes = 64}};
  FrozenCounts accelerometer_{{.one_axis = 64, .three_axes = 20}};
  std::uint8_t all_the_same_ = 0;  ///< samples, one after the other, with all six axes as before
  ImuSample sample_{};
};

}  // namespace fantail::hal::stm32f4
