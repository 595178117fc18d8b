// SPDX-License-Identifier: MIT

#include "hal/stm32f4/watchdog.hpp"

#include "fake_iwdg.hpp"
#include "fake_slow_oscillator.hpp"
#include "hal/stm32f4/slow_oscillator.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeIwdg;
using test::FakeSlowOscillator;
using test::RegisterWorld;

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
