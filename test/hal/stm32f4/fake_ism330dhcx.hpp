// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "fake_addressed.hpp"
#include "fake_clock.hpp"

namespace fantail::hal::stm32f4::test {

/// An ISM330DHCX as ST's own driver and examples use it, as far as our driver can see it: a reset that ends by itself,
/// other registers behind FUNC_CFG_ACCESS, outputs that swing after switching on, samples whose bytes do not belong
/// together without BDU, self-test. And what is reported of it: without DEVICE_CONF it does not take over a fast rate,
/// and devices that do take it read that bit as zero (ST's community, question 24942).
class FakeIsm330dhcx final : public AddressedSlave {
 public:
  explicit FakeIsm330dhcx(const FakeClock& clock) : clock_{clock} { reset(); }

  // ---- what it measures ----
  std::array<double, 3> rate_deg_s{};
  std::array<double, 3> force_g{0.0, 0.0, 1.0};
  double noise_counts = 1.0;       ///< up or down by this
  double actuation_deg_s = 400.0;  ///< of its self-test

  // ---- faults ----
  std::uint8_t id = 0x6B;
  bool stopped = false;  ///< no new samples
  bool frozen = false;   ///< new samples, and always the same
  bool shows_device_conf = true;
  bool never_ends_reset = false;
  /// Its supply was gone for a moment.
  void reset();

  [[nodiscard]] std::uint8_t reg(std::uint8_t address) const { return registers_[address]; }
  int resets = 0;

  [[nodiscard]] Needs needs() const override { return {.modes = {3}, .most_hz = 10'000'000}; }

 private:
  void update() override;
  void spoken_to() override {}
  std::uint8_t read(std::uint8_t address) override;
  void write(std::uint8_t address, std::uint8_t value) override;
  void put(std::uint8_t address, double counts);
  [[nodiscard]] bool shows_others() const { return registers_[1] != 0; }

  const FakeClock& clock_;
  std::array<std::uint8_t, 128> registers_{};
  Microseconds reset_until_{};
  Microseconds switched_on_{};
  std::int64_t samples_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
