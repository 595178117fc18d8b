// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/entropy.hpp"
#include "hal/stm32f4/registers/rng.hpp"

namespace fantail::hal::stm32f4 {

/// The processor's random number generator, with the test that its manual asks for: no number comes twice in a row.
class Entropy final : public hal::Entropy {
 public:
  explicit Entropy(registers::Rng& device);

  /// Of a generator that has failed the last good number, again.
  std::uint32_t draw() override;

  /// It repeated itself, had no clock or no noise, or did not answer in time, at least once since power-up.
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  void begin_anew();

  registers::Rng* device_;
  std::uint32_t last_ = 0;
  bool failed_ = false;
};

}  // namespace fantail::hal::stm32f4
