// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fake_addressed.hpp"
#include "fake_clock.hpp"

namespace fantail::hal::stm32f4::test {

/// A KX134-1211 as its Technical Reference Manual describes it, as far as the driver can see it.
class FakeKx134 final : public AddressedSlave {
 public:
  explicit FakeKx134(const FakeClock& clock) : clock_{clock} { reset(); }

  std::array<double, 3> force_g{0.0, 0.0, 1.0};
  bool noisy = true;  ///< some counts on each axis

  // ---- faults ----
  std::uint8_t id = 0x46;
  std::uint8_t test_response = 0x55;
  bool frozen = false;  ///< no new samples
  /// Its supply was gone for a moment.
  void reset();

  [[nodiscard]] std::uint8_t reg(std::uint8_t address) const { return registers_[address]; }
  int resets = 0;

  [[nodiscard]] Needs needs() const override { return {.modes = {0}, .most_hz = 10'000'000}; }

 private:
  void update() override;
  void spoken_to() override;
  std::uint8_t read(std::uint8_t address) override;
  void write(std::uint8_t address, std::uint8_t value) override;

  const FakeClock& clock_;
  std::array<std::uint8_t, 128> registers_{};
  Microseconds reset_until_{};
  Microseconds switched_on_{};
  std::int64_t samples_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
