// SPDX-License-Identifier: MIT

#include "hal/stm32f4/backup_memory.hpp"

#include "fake_rtc.hpp"
#include "hal/stm32f4/backup_clock.hpp"
#include "hal/stm32f4/reset_cause.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

TEST(TheBackupMemory, IsTheMemoryItWasGivenOnceItsDomainMayBeWritten) {
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  std::array<std::byte, 4096> cells{};
  BackupMemory memory{rcc, pwr, rtc, cells};
  EXPECT_EQ(RegisterWorld::peek(rcc.apb1enr), 1U << 28U);
  EXPECT_EQ(RegisterWorld::peek(pwr.cr), 1U << 8U);
  EXPECT_EQ(RegisterWorld::peek(rcc.ahb1enr), 1U << 18U);
  EXPECT_EQ(memory.bytes().data(), cells.data());
  EXPECT_EQ(memory.bytes().size(), 4096U);
}

TEST(TheBackupMemory, OpensTheDomainOnlyWhenThePowerControlHasItsClock) {
  RegisterWorld world;
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  world.on_write(pwr.cr, [&](std::uint32_t value) {
    if ((RegisterWorld::peek(rcc.apb1enr) >> 28U & 1U) != 0) {
      RegisterWorld::poke(pwr.cr, value);
    }
  });
  const BackupMemory memory{rcc, pwr, rtc, {}};
  EXPECT_EQ(RegisterWorld::peek(pwr.cr), 1U << 8U);
}

TEST(TheBackupMemory, IsNoneWhereItsDomainStaysClosed) {
  RegisterWorld world;
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  world.on_write(pwr.cr, [](std::uint32_t) {});  // as in the emulator
  std::array<std::byte, 4096> cells{};
  BackupMemory memory{rcc, pwr, rtc, cells};
  EXPECT_TRUE(memory.bytes().empty());
}

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

using test::RegisterWorld;

/// The flags of RM0090 section 7.3.21 add up until RMVF clears them.
struct FakeResets {
  registers::Rcc rcc{};
  std::uint32_t flags = 0;
  explicit FakeResets(RegisterWorld& world) {
    world.on_read(rcc.csr, [this] { return flags | 3U; });  // and the slow oscillator, on and ready
    world.on_write(rcc.csr, [this](std::uint32_t value) { flags = (value >> 24U & 1U) != 0 ? 0 : flags; });
  }
};

struct TakeResetCause : testing::Test {
  RegisterWorld world{};
  FakeResets resets{world};
  ResetCause after(std::uint32_t flags) {
    resets.flags |= flags;
    return take_reset_cause(resets.rcc);
  }
};

constexpr std::uint32_t brown_out = 1U << 25U;
constexpr std::uint32_t pin = 1U << 26U;
constexpr std::uint32_t power_on = 1U << 27U;
constexpr std::uint32_t software = 1U << 28U;
constexpr std::uint32_t watchdog = 1U << 29U;

TEST_F(TakeResetCause, EachIsToldFromTheFlagsThatComeWithIt) {
  EXPECT_EQ(after(power_on | brown_out | pin), ResetCause::power_on);
  EXPECT_EQ(after(brown_out | pin), ResetCause::brown_out);
  EXPECT_EQ(after(watchdog | pin), ResetCause::watchdog);
  EXPECT_EQ(after(1U << 30U | pin), ResetCause::watchdog);
  EXPECT_EQ(after(software | pin), ResetCause::software);
  EXPECT_EQ(after(pin), ResetCause::pin);
}

TEST_F(TakeResetCause, IsForgottenOnceItWasTaken) {
  EXPECT_EQ(after(power_on | brown_out | pin), ResetCause::power_on);
  EXPECT_EQ(resets.flags, 0U);
  EXPECT_EQ(after(watchdog | pin), ResetCause::watchdog);
}

TEST_F(TakeResetCause, APowerOnBehindAnyOtherResetIsAPowerOn) {
  resets.flags = power_on | brown_out | pin;
  EXPECT_EQ(after(watchdog | software | pin), ResetCause::power_on);
}

TEST_F(TakeResetCause, WithoutAnyFlagItCountsAsAPowerOnWhichNothingSurvives) {
  EXPECT_EQ(after(0), ResetCause::power_on);
}

}  // namespace

}  // namespace fantail::hal::stm32f4
