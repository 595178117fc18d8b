// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "fake_addressed.hpp"
#include "fake_capture.hpp"
#include "fake_clock.hpp"

namespace fantail::hal::stm32f4::test {

/// An ICM-42688-P as DS-000347 revision 1.8 describes it, as far as the driver can see it: five banks of registers,
/// reset, start-up times, data-ready, self-test; and what the data sheet does not say: unless bits 7:6 of INTF_CONFIG1
/// are 01, an axis that passes 100 deg/s changes between two ranges of its own, and its gyro repeats a value meanwhile,
/// for 1 to 2 ms (ArduPilot's issue 25025 and Betaflight's pull request 13132). It is as noisy as the data sheet says.
/// What must not be done to it is written down in `violations`.
class FakeIcm42688 final : public AddressedSlave {
 public:
  explicit FakeIcm42688(const FakeClock& clock);

  // ---- what it measures ----
  std::array<double, 3> rate_deg_s{};
  std::array<double, 3> force_g{0.0, 0.0, 1.0};
  /// The self-test's actuation, as a part of what the factory noted.
  double gyro_noise_deg_s = 0.047;                    ///< rms: 0.0028 deg/s/sqrt(Hz), section 3.1, in 286 Hz
  double accelerometer_noise_g = 0.0011;              ///< 65 ug/sqrt(Hz), section 3.2
  double period_us = 1'000.0;                         ///< by its own clock
  std::function<void(Microseconds)> before_sample{};  ///< it is about to measure, at this time
  double gyro_actuation = 1.0;
  double accelerometer_actuation = 1.0;
  std::array<std::uint8_t, 3> gyro_codes{90, 100, 110};
  std::array<std::uint8_t, 3> accelerometer_codes{80, 85, 90};

  // ---- faults ----
  std::uint8_t id = 0x47;
  bool frozen = false;                 ///< no new samples
  std::array<bool, 3> gyro_repeats{};  ///< new samples, with the old value on this axis
  std::array<bool, 3> accelerometer_repeats{};
  std::function<void()> before_status{};  ///< happens once, just before INT_STATUS is read
  /// Its supply was gone for a moment.
  void reset();

  /// When INT1 rose last; empty before the first time, or as long as it is not a push-pull output with pulses.
  std::optional<LineEdge> interrupt_1();

  [[nodiscard]] std::uint8_t reg(std::uint8_t bank, std::uint8_t address) const { return registers_[bank][address]; }
  int resets = 0;
  int writes = 0;

  [[nodiscard]] Needs needs() const override { return {.modes = {0, 3}, .most_hz = 24'000'000, .select_ns = 39}; }

 private:
  void update() override;
  void spoken_to() override;
  void write(std::uint8_t address, std::uint8_t value) override;
  std::uint8_t read(std::uint8_t address) override;
  [[nodiscard]] bool gyro_is_stuck(std::uint8_t axis);
  void put(std::uint8_t address, double value, double full_scale);
  void raise_interrupt_1(Microseconds time, std::int64_t edges);

  const FakeClock& clock_;
  std::array<std::array<std::uint8_t, 128>, 5> registers_{};
  std::uint8_t bank_ = 0;
  Microseconds reset_until_{};
  Microseconds switched_on_{-1'000'000};
  Microseconds gyro_ready_{};
  Microseconds accelerometer_ready_{};
  std::int64_t samples_ = 0;
  std::array<bool, 3> fast_{};
  std::array<std::int64_t, 3> stuck_until_{};
  std::optional<LineEdge> interrupt_1_{};
  std::array<double, 3> held_deg_s_{};
  std::array<double, 3> held_g_{};
  std::mt19937 random_{1};
};

}  // namespace fantail::hal::stm32f4::test
