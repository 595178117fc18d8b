// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/rng.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// RM0090 section 24: a number some time after the one before was taken; an error stays until it is cleared, and after
/// an error of the seed there are no numbers until it is started again.
struct FakeRng {
  registers::Rng registers{};
  int looks_per_number = 10;
  bool has_clock = true;
  bool repeats = false;
  std::uint32_t next = 1000;

  explicit FakeRng(RegisterWorld& world) {
    world.on_write(registers.cr, [this](std::uint32_t value) {
      const bool enabled = (value & 4U) != 0;
      if (enabled && !enabled_) {
        looks_left_ = looks_per_number;
        stopped_ = seed_error_;
      }
      enabled_ = enabled;
    });
    world.on_write(registers.sr, [this](std::uint32_t value) { seed_error_ = seed_error_ && (value >> 6U & 1U) != 0; });
    world.on_read(registers.sr, [this] {
      const bool ready = enabled_ && has_clock && !stopped_ && --looks_left_ <= 0;
      return (ready ? 1U : 0U) | (has_clock ? 0U : 0x22U) | (seed_error_ ? 0x40U : 0U);
    });
    world.on_read(registers.dr, [this] {
      looks_left_ = looks_per_number;
      next += repeats ? 0 : 7;
      return next;
    });
  }
  void lose_noise() { seed_error_ = stopped_ = true; }
  /// The error comes when a number is ready, which is then not to be used.
  void lose_noise_behind_a_number() { seed_error_ = true; }

 private:
  bool enabled_ = false;
  bool seed_error_ = false;
  bool stopped_ = false;
  int looks_left_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
