// SPDX-License-Identifier: MIT
#include "hal/stm32f4/slow_oscillator.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

/// Channel 4 of TIM5 with the oscillator at its input: RM0090 sections 7.2.11 and 18.3.5. Time passes with each look.
struct FakeSlowOscillator {
  registers::Rcc rcc{};
  registers::Tim tim5{};
  double hz = 32e3;
  double jitter = 0.0;  ///< of one cycle, as a part of it
  bool starts = true;
  double timer_hz = 84e6;
  static constexpr double look_s = 100e-9;

  explicit FakeSlowOscillator(RegisterWorld& world) {
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
    time_s_ += look_s;
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

  double time_s_ = 0.0;
  double edge_s_ = 0.0;
  int edges_ = 0;
  double value_ = 0.0;
  bool captured_ = false;
};

TEST(TheSlowOscillator, IsMeasuredToAHundredthOverItsWholeSpread) {
  for (double hz = 17e3; hz <= 47e3; hz += 250) {
    RegisterWorld world;
    FakeSlowOscillator device{world};
    device.hz = hz;
    device.jitter = 0.02;
    const auto measured = measure_slow_oscillator(device.rcc, device.tim5, 84'000'000);
    ASSERT_TRUE(measured) << hz;
    EXPECT_NEAR(*measured, hz, 0.01 * hz);
    EXPECT_LT(static_cast<double>(world.accesses()) * FakeSlowOscillator::look_s, 0.0011)
        << "a start has to wait for it";
  }
}

TEST(TheSlowOscillator, IsMeasuredByASlowProcessorToo) {
  RegisterWorld world;
  FakeSlowOscillator device{world};
  device.timer_hz = 16e6;
  EXPECT_NEAR(measure_slow_oscillator(device.rcc, device.tim5, 16'000'000).value(), 32e3, 100);
}

TEST(TheSlowOscillator, OneThatDoesNotStartIsWaitedForAMillisecondAndNotMeasured) {
  RegisterWorld world;
  FakeSlowOscillator device{world};
  device.starts = false;
  EXPECT_FALSE(measure_slow_oscillator(device.rcc, device.tim5, 84'000'000));
  EXPECT_LT(world.accesses(), 10'100U);
}

TEST(TheSlowOscillator, OneOutsideOfWhatTheDataSheetAllowsIsNotBelieved) {
  for (const double hz : {9e3, 16e3, 49e3, 200e3}) {
    RegisterWorld world;
    FakeSlowOscillator device{world};
    device.hz = hz;
    EXPECT_FALSE(measure_slow_oscillator(device.rcc, device.tim5, 84'000'000)) << hz;
  }
}

TEST(TheSlowOscillator, LeavesTheTimerWithoutAClock) {
  RegisterWorld world;
  FakeSlowOscillator device{world};
  (void)measure_slow_oscillator(device.rcc, device.tim5, 84'000'000);
  EXPECT_EQ(RegisterWorld::peek(device.rcc.apb1enr) & 1U << 3U, 0U);
  EXPECT_EQ(RegisterWorld::peek(device.tim5.cr1), 0U);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
