// SPDX-License-Identifier: MIT
#include "hal/stm32f4/backup_clock.hpp"

#include <gtest/gtest.h>

#include "fake_rtc.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeRtc;
using test::RegisterWorld;

double in_seconds(const std::optional<Microseconds>& time) { return 1e-6 * static_cast<double>(time.value().count()); }

void tick(BackupClock& clock, FakeRtc& device, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    clock.update();
    device.pass(0.001);
  }
}

struct TheBackupClock : testing::Test {
  RegisterWorld world{};
  FakeRtc device{world};
};

TEST_F(TheBackupClock, HasNoTimeUntilItsCrystalHasStartedAndThenRunsFromZero) {
  BackupClock clock{device.rcc, device.device};
  tick(clock, device, 1000);
  EXPECT_FALSE(clock.now());
  tick(clock, device, 10);
  ASSERT_TRUE(clock.now());
  EXPECT_LT(*clock.now(), Microseconds{10'000});
}

TEST_F(TheBackupClock, NeverWaits) {
  device.crystal_starts_in_s = -1;
  BackupClock clock{device.rcc, device.device};
  const auto before = world.accesses();
  tick(clock, device, 1000);
  EXPECT_LE(world.accesses() - before, 1000U) << "one look a tick";
  EXPECT_FALSE(clock.now()) << "this board has no such crystal";
}

TEST_F(TheBackupClock, CountsToThirtyOneMicrosecondsAcrossSecondsMinutesAndHours) {
  BackupClock clock{device.rcc, device.device};
  tick(clock, device, 1010);
  for (const double apart_s : {0.0001, 0.0123, 0.9999, 1.0, 59.5, 3'600.25, 40'000.0}) {
    const double before_s = in_seconds(clock.now());
    device.pass(apart_s);
    EXPECT_NEAR(in_seconds(clock.now()) - before_s, apart_s, 40e-6) << apart_s;
  }
}

TEST_F(TheBackupClock, ALookAcrossACarryIsNotOffByASecond) {
  BackupClock clock{device.rcc, device.device};
  tick(clock, device, 1010);
  double before_s = in_seconds(clock.now());
  for (int i = 0; i < 200'000; ++i) {
    device.pass(9e-6);
    if (const auto now = clock.now()) {
      ASSERT_LT(in_seconds(now) - before_s, 100e-6);
      ASSERT_GE(in_seconds(now), before_s);
      before_s = in_seconds(now);
    }
  }
}

TEST_F(TheBackupClock, GoesOnOverAResetOfTheProcessorAndIsThereAtOnce) {
  BackupClock before{device.rcc, device.device};
  tick(before, device, 1010);
  const double then_s = in_seconds(before.now());
  device.pass(0.0573);
  device.reset_of_the_processor();
  const BackupClock after{device.rcc, device.device};
  EXPECT_NEAR(in_seconds(after.now()) - then_s, 0.0573, 40e-6);
}

TEST_F(TheBackupClock, AResetWhileItIsBeingSetLeavesNoTimeAndItIsSetThen) {
  for (int steps = 1; steps < 5; ++steps) {
    RegisterWorld own_world;
    FakeRtc own{own_world};
    own.crystal_starts_in_s = 0.0;
    BackupClock before{own.rcc, own.device};
    tick(before, own, steps);
    own.reset_of_the_processor();
    BackupClock after{own.rcc, own.device};
    tick(after, own, 10);
    ASSERT_TRUE(after.now()) << steps;
    EXPECT_LT(*after.now(), Microseconds{20'000}) << steps;
  }
}

TEST_F(TheBackupClock, ASourceThatOtherFirmwareChoseIsNotTakenForTheCrystal) {
  device.rcc.bdcr.write(1U | 2U << 8U | 1U << 15U);  // the internal oscillator
  device.pass(2);
  BackupClock clock{device.rcc, device.device};
  tick(clock, device, 100);
  EXPECT_FALSE(clock.now());
}

}  // namespace
}  // namespace fantail::hal::stm32f4
