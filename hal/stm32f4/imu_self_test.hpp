// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/clock.hpp"
#include "hal/stm32f4/spi_registers.hpp"

namespace fantail::hal::stm32f4 {

/// The electrical self-test of an ICM-42688-P (DS-000347 section 4.9): actuated by the sensor itself, each axis has to
/// move by what its factory noted. It is the procedure and the limits of the maker's own driver, whole: the data sheet
/// only says that there is one. It takes 1.1 s, and nothing waits for it: it is carried on once a tick.
class ImuSelfTest {
 public:
  enum class State : std::uint8_t {
    running,
    passed,
    failed,  ///< an axis moved too little or too much, or the gyro was turned all the while
    broken,  ///< the device stopped answering
  };
  using Axes = std::array<std::int32_t, 3>;
  using Codes = std::array<std::uint8_t, 3>;

  /// The device has just been reset, and both sensors are off.
  void begin() { *this = {}; }
  State step(SpiRegisters& registers, Microseconds now);

  /// Means in counts of 250 deg/s and 2 g full scale, without and with actuation; the codes of the factory.
  [[nodiscard]] static bool gyro_passes(const Axes& off, const Axes& on, const Codes& codes);
  [[nodiscard]] static bool accelerometer_passes(const Axes& off, const Axes& on, const Codes& codes);

 private:
  static constexpr std::size_t phases = 4;

  bool configure(SpiRegisters& registers);
  bool begin_phase(SpiRegisters& registers, Microseconds now);
  bool collect(SpiRegisters& registers);
  State judge(SpiRegisters& registers);

  bool configured_ = false;
  bool phase_begun_ = false;
  std::size_t phase_ = 0;
  Microseconds settled_at_{};
  std::int32_t samples_ = 0;
  std::array<Axes, phases> means_{};  ///< sums, until a phase has ended
};

}  // namespace fantail::hal::stm32f4
