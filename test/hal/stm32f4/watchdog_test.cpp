// SPDX-License-Identifier: MIT
#include "hal/stm32f4/watchdog.hpp"

#include <gtest/gtest.h>

#include "register_world.hpp"

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

}  // namespace
}  // namespace fantail::hal::stm32f4
