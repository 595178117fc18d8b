// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hal/barometer.hpp"
#include "hal/clock.hpp"
#include "hal/stm32f4/ms5611.hpp"
#include "hal/stm32f4/sensor_start.hpp"
#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4 {

/// TE MS5611-01BA03, a pressure and a temperature in turn: a sample every 10 ms, with 1.8 Pa (15 cm) of noise. Why this
/// one: it measures from 1 to 120 kPa, so to above 30 km; altimeters of rockets have flown it or its sibling, the
/// MS5607, for years, so how it fails is known; and it is sold on boards whose SPI pins are brought out.
///
/// Nothing here waits, as with the other sensors: each read() carries reset, constants and conversions on by one step,
/// with at most seven bytes on the wire. There may be none: then it says no_reading, and looks for one every 20 ms. The
/// first sample comes 25 ms after the first read(). What is wrong with it has no name among the board's faults, as with
/// the second IMU.
///
/// It has no identity and no status. So what is asked of it:
/// - its constants have their CRC, and say the same twice: a CRC of four bits lets one in sixteen of what a noisy line
///   makes of them pass;
/// - each conversion has a result. Without one it has lost its supply, and must load its constants again: it is reset;
/// - the first conversion after a reset is thrown away: first ones are reported that were wrong;
/// - temperature and pressure are within its ranges;
/// - neither stands still.
///
/// It cannot be told that light falls on it or that its port is blocked. An MS5607 has the same commands and reads
/// half: avionics/self_test finds it.
class Barometer final : public hal::Barometer {
 public:
  /// The bus of the device and the clock outlive this object.
  Barometer(SpiDevice device, const hal::Clock& clock) : device_{device}, clock_{clock} {}

  /// Before the first read(). Nothing is sent yet. It keeps no settings that could be taken as they are, and a reset
  /// may come at any time: in flight it is started as at power-up.
  void start(SensorStart /*how*/) { stage_ = Stage::reset; }
  /// Once a tick.
  BarometerSample read() override;

  /// Equal results in a row, the first not counted, of pressure or of temperature. With Gaussian noise each further one
  /// is equal with a probability of at most erf(1 / (2 sqrt(2) noise in counts)). The data sheet's noise is 94 counts
  /// of pressure and 89 of temperature, but a fortieth of it would be enough to hold the false alarms below 1e-9 in an
  /// hour (test/hal/stm32f4/barometer_trouble_test.cpp).
  static constexpr std::uint8_t most_repeats = 20;

 private:
  enum class Stage : std::uint8_t { reset, constants, settling, temperature, pressure };
  using Constants = std::array<std::uint16_t, ms5611::constants>;

  /// The results of one of its two sensors. What stood still is believed again after it has moved ten times.
  class Results {
   public:
    /// True when it is found that they stand still, and again each time it is.
    bool update(std::uint32_t result);
    [[nodiscard]] std::uint32_t last() const { return last_; }
    [[nodiscard]] bool doubtful() const { return doubts_ > 0; }

   private:
    std::uint32_t last_ = 0;
    std::uint8_t repeats_ = 0;
    std::uint8_t doubts_ = 0;  ///< moves until they are believed again
  };

  bool command(std::uint8_t command);
  std::optional<std::uint16_t> constant(std::uint8_t number);
  std::uint32_t result();

  void reset(Microseconds now);
  void read_constants(Microseconds now);
  void convert(Microseconds now, Stage stage);
  void carry_on(Microseconds now);
  void take_pressure();
  void restart(Status status);

  SpiDevice device_;
  const hal::Clock& clock_;
  Stage stage_ = Stage::reset;
  std::uint8_t next_constant_ = 0;
  Microseconds since_{};  ///< of the reset, or of the conversion
  std::optional<Microseconds> reset_at_;
  Constants constants_{};
  Results pressure_;
  Results temperature_;
  BarometerSample sample_{};
};

}  // namespace fantail::hal::stm32f4
