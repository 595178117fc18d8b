// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/iwdg.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// RM0090 section 21: keys open and close it, and what is written to it arrives later.
struct FakeIwdg {
  registers::Iwdg registers{};
  double oscillator_hz = 32e3;
  int looks_until_taken = 30;
  bool has_reset = false;

  explicit FakeIwdg(RegisterWorld& world) {
    world.on_write(registers.kr, [this](std::uint32_t key) {
      unlocked_ = key == 0x5555;
      running_ = running_ || key == 0xCCCC;
      if (key == 0xAAAA) {
        counted_ = 0;
        reload_ = taken_rlr_;
      }
    });
    world.on_write(registers.pr, [this](std::uint32_t value) { write(pr_, value); });
    world.on_write(registers.rlr, [this](std::uint32_t value) { write(rlr_, value); });
    world.on_read(registers.sr, [this] {
      if (running_ && --looks_left_ <= 0) {
        taken_pr_ = pr_;
        taken_rlr_ = rlr_;
        return 0U;
      }
      return 3U;
    });
  }

  void pass(double seconds) {
    if (running_) {
      counted_ += seconds * oscillator_hz / (4 << taken_pr_);
      has_reset = has_reset || counted_ > reload_ + 1;
    }
  }
  /// Unfed, to the nearest tenth of a millisecond.
  double seconds_to_reset() {
    for (int step = 0; step < 100'000; ++step) {
      if (has_reset) {
        return step * 1e-4;
      }
      pass(1e-4);
    }
    return 10;
  }

 private:
  void write(std::uint32_t& place, std::uint32_t value) {
    if (unlocked_) {
      place = value;
      looks_left_ = looks_until_taken;
    }
  }

  bool unlocked_ = false;
  bool running_ = false;
  std::uint32_t pr_ = 0;
  std::uint32_t rlr_ = 0xFFF;
  std::uint32_t taken_pr_ = 0;
  std::uint32_t taken_rlr_ = 0xFFF;
  std::uint32_t reload_ = 0xFFF;
  int looks_left_ = 0;
  double counted_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
