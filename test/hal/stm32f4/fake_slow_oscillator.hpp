// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "hal/stm32f4/registers/rcc.hpp"
#include "hal/stm32f4/registers/tim.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// Channel 4 of TIM5 with the oscillator at its input: RM0090 sections 7.2.11 and 18.3.5. Time passes with each look,
/// unless it has a clock.
struct FakeSlowOscillator {
 private:
  registers::Rcc own_rcc_{};

 public:
  registers::Rcc& rcc;
  registers::Tim tim5{};
  double hz = 32e3;
  double jitter = 0.0;  ///< of one cycle, as a part of it
  bool starts = true;
  double timer_hz = 84e6;
  static constexpr double look_s = 100e-9;

  explicit FakeSlowOscillator(RegisterWorld& world) : FakeSlowOscillator{world, own_rcc_, {}} {}
  /// In a chip that has its RCC already; `now_s`: since power-up.
  FakeSlowOscillator(RegisterWorld& world, registers::Rcc& shared_rcc, std::function<double()> now_s)
      : rcc{shared_rcc}, now_s_{std::move(now_s)} {
    world.on_read(tim5.sr, [this] {
      pass();
      return captured_ ? 1U << 4U : 0U;
    });
    world.on_read(tim5.ccr[3], [this] {
      captured_ = false;
      return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value_) & 0xFFFFFFFFU);
    });
  }

 private:
  [[nodiscard]] bool listens() const {
    const auto set = [](const registers::Register& place, std::uint32_t bits) {
      return (RegisterWorld::peek(place) & bits) == bits;
    };
    return starts && set(rcc.csr, 1) && set(rcc.apb1enr, 1U << 3U) && RegisterWorld::peek(tim5.option) == 1U << 6U &&
           RegisterWorld::peek(tim5.ccmr[1]) == (1U << 8U | 3U << 10U) && set(tim5.ccer, 1U << 12U) && set(tim5.cr1, 1);
  }
  void pass() {
    time_s_ = now_s_ ? now_s_() : time_s_ + look_s;
    if (!listens()) {
      return;
    }
    edge_s_ = edge_s_ == 0 ? time_s_ + 0.3 / hz : edge_s_;
    while (edge_s_ < time_s_) {
      edges_ += 1;
      if (edges_ % 8 == 0) {
        value_ = 4'000'000'000.0 + edge_s_ * timer_hz;  // soon it begins at zero again
        captured_ = true;
      }
      edge_s_ += (1.0 + (edges_ % 2 == 0 ? jitter : -jitter)) / hz;
    }
  }

  std::function<double()> now_s_;
  double time_s_ = 0.0;
  double edge_s_ = 0.0;
  int edges_ = 0;
  double value_ = 0.0;
  bool captured_ = false;
};

}  // namespace fantail::hal::stm32f4::test
