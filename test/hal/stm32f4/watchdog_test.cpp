// SPDX-License-Identifier: MIT

#include "hal/stm32f4/watchdog.hpp"

#include "hal/stm32f4/slow_oscillator.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

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

struct TheWatchdog : testing::Test {
  RegisterWorld world{};
  FakeIwdg device{world};
  Watchdog watchdog{device.registers};
};

TEST_F(TheWatchdog, DoesNothingBeforeItIsStarted) {
  watchdog.feed();
  EXPECT_EQ(device.seconds_to_reset(), 10);
}

TEST_F(TheWatchdog, ResetsFiftyMillisecondsAfterTheLastFeed) {
  EXPECT_TRUE(watchdog.start(32'000));
  device.pass(0.049);
  watchdog.feed();
  EXPECT_NEAR(device.seconds_to_reset(), 0.050, 0.0003);
}

TEST_F(TheWatchdog, TheFirstFiftyMillisecondsBeginWithTheStart) {
  EXPECT_TRUE(watchdog.start(32'000));
  EXPECT_NEAR(device.seconds_to_reset(), 0.050, 0.0003);
}

TEST_F(TheWatchdog, ALoopThatFeedsItEachMillisecondLives) {
  EXPECT_TRUE(watchdog.start(32'000));
  for (int tick = 0; tick < 5'000; ++tick) {
    device.pass(0.001);
    watchdog.feed();
  }
  EXPECT_FALSE(device.has_reset);
}

TEST_F(TheWatchdog, ResetsAfterFiftyMillisecondsOverTheWholeSpreadOfAnOscillatorThatWasMeasured) {
  for (std::uint32_t hz = 17'000; hz <= 47'000; hz += 500) {
    RegisterWorld own_world;
    FakeIwdg own{own_world};
    own.oscillator_hz = hz;
    EXPECT_TRUE(Watchdog{own.registers}.start(hz));
    EXPECT_NEAR(own.seconds_to_reset(), 0.050, 0.0004) << hz;  // four cycles of 17 kHz are 0.24 ms
  }
}

TEST_F(TheWatchdog, TheFastestOscillatorThatNobodyMeasuredLeavesThirtyFourTicks) {
  EXPECT_TRUE(watchdog.start({}));
  device.oscillator_hz = 47e3;
  EXPECT_NEAR(device.seconds_to_reset(), 0.0340, 0.0003);
}

TEST_F(TheWatchdog, TheSlowestOscillatorThatNobodyMeasuredResetsWithinNinetyFiveMilliseconds) {
  EXPECT_TRUE(watchdog.start({}));
  device.oscillator_hz = 17e3;
  EXPECT_NEAR(device.seconds_to_reset(), 0.0941, 0.0003);
}

TEST_F(TheWatchdog, OneThatNeverTakesItsPeriodSaysSoAndGuardsAllTheSame) {
  device.looks_until_taken = 1'000'000;
  EXPECT_FALSE(watchdog.start(32'000));
  EXPECT_NEAR(device.seconds_to_reset(), 0.512, 0.0003);
  EXPECT_LT(world.accesses(), 30'000U);
}

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
