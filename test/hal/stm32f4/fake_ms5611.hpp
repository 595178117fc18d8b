// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "fake_clock.hpp"
#include "fake_spi.hpp"

namespace fantail::hal::stm32f4::test {

/// An MS5611-01BA03 as quotations of its data sheet describe it, command by command, as far as the driver can see it:
/// a reset that needs time, constants with a CRC, conversions that need time, have one result and are spoilt by who
/// interrupts them. And what is reported of it: without a reset after its supply came back it measures wrongly, the
/// first conversion after a reset is wrong, light makes it measure another pressure, and devices sold under its name
/// are MS5607.
class FakeMs5611 final : public SpiSlave {
 public:
  using Constants = std::array<std::uint16_t, 8>;

  explicit FakeMs5611(const FakeClock& clock);

  // ---- what it measures ----
  double pressure_pa = 101'325.0;
  double temperature_c = 20.0;
  double noise_counts = 90.0;  ///< 1.8 Pa and 0.003 degrees C
  /// Those of the data sheet's example, with their CRC.
  Constants constants;
  /// The low nibble of the last word becomes the CRC of the others.
  static Constants with_crc(Constants constants);
  /// Instead of what it measures.
  std::optional<std::uint32_t> pressure_result{};
  std::optional<std::uint32_t> temperature_result{};

  // ---- faults ----
  std::optional<std::uint8_t> stuck_at{};  ///< answers nothing but this
  /// What a disturbance makes of each byte that it answers.
  std::function<std::uint8_t(std::uint8_t answer)> disturbance{};
  bool never_ready = false;      ///< no conversion has a result
  bool pressure_frozen = false;  ///< conversions have the result of the last one
  bool temperature_frozen = false;
  bool is_ms5607 = false;
  double light_pa = 0.0;                  ///< by so much light on it makes the pressure seem higher
  std::optional<double> blocked_at_pa{};  ///< what is behind its blocked port
  /// Its supply was gone for a moment.
  void lose_power();

  // ---- what was seen ----
  int resets = 0;
  int conversions = 0;
  /// What must not be done to this device, and was.
  std::vector<std::string> violations{};

  [[nodiscard]] Needs needs() const override { return {.modes = {0, 3}, .most_hz = 20'000'000}; }
  void selected() override;
  std::uint8_t exchange(std::uint8_t out) override;
  void deselected() override {}

 private:
  [[nodiscard]] bool converting() const { return clock_.time < ready_at_; }
  void obey(std::uint8_t command);
  void convert(std::uint8_t command);
  [[nodiscard]] double measured(bool pressure) const;
  void answer(std::uint32_t value, std::size_t bytes);

  const FakeClock& clock_;
  std::mt19937 random_{1};
  std::optional<std::uint8_t> command_;
  std::vector<std::uint8_t> answer_;  ///< what is still to be shifted out, the next byte last
  Microseconds loaded_at_{};          ///< the end of its reset
  Microseconds ready_at_{};           ///< the end of the conversion
  std::uint32_t result_ = 0;
  std::array<std::uint32_t, 2> frozen_{};
  bool calibrated_ = false;  ///< it was told to reset since its supply came back
  bool first_ = true;        ///< no conversion was made since
};

}  // namespace fantail::hal::stm32f4::test
