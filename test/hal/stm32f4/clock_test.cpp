// SPDX-License-Identifier: MIT

#include "hal/stm32f4/clock.hpp"

#include "fake_clocks.hpp"
#include "fake_systick.hpp"
#include "hal/stm32f4/clock_tree.hpp"
#include "register_world.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace std::chrono_literals;
using test::FakeSysTick;
using test::RegisterWorld;

constexpr std::uint32_t full_speed_hz = 168'000'000;
constexpr std::uint32_t counts_per_millisecond = 168'000;

struct TheClock : testing::Test {
  RegisterWorld world{};
  FakeSysTick systick{world};
  Clock clock{systick.timer, systick.system, full_speed_hz};
  TheClock() {
    systick.handler = [this] { clock.tick(); };
  }
  void pass(std::chrono::microseconds time) { systick.pass(static_cast<std::uint64_t>(time.count()) * 168); }
};

TEST_F(TheClock, TheTimerInterruptsAThousandTimesASecondFromTheProcessorsOwnClock) {
  EXPECT_EQ(systick.load(), counts_per_millisecond - 1);
  EXPECT_EQ(systick.ctrl(), 7U);
}

TEST_F(TheClock, TheSlowProcessorHasTheSameMillisecond) {
  const Clock slow{systick.timer, systick.system, 16'000'000};
  EXPECT_EQ(systick.load(), 15'999U);
}

TEST_F(TheClock, CountsMicrosecondsWithinAMillisecondAndAcrossMany) {
  EXPECT_EQ(clock.now(), 0us);
  pass(500us);
  EXPECT_EQ(clock.now(), 500us);
  pass(12'345us);
  EXPECT_EQ(clock.now(), 12'845us);
}

TEST_F(TheClock, GoesOnWhereItIsTold) {
  pass(2'300us);
  clock.begin_at(61s);
  EXPECT_EQ(clock.now(), 61s);
  pass(1'700us);
  EXPECT_EQ(clock.now(), 61s + 1'700us);
}

TEST_F(TheClock, SaysHowLongAgoAMillisecondBeganWhateverTimeItGoesOnAt) {
  pass(2'300us);
  EXPECT_EQ(clock.since_tick(), 300us);
  clock.begin_at(Microseconds{61'000'123});
  EXPECT_EQ(clock.since_tick(), 300us);
  pass(900us);
  EXPECT_EQ(clock.since_tick(), 200us);
}

TEST_F(TheClock, IsRightWhileItsInterruptHasToWait) {
  pass(990us);
  systick.processor.masked = true;
  pass(100us);
  ASSERT_TRUE(systick.pending());
  EXPECT_EQ(clock.now(), 1'090us);
  pass(890us);
  EXPECT_EQ(clock.now(), 1'980us);
  systick.processor.masked = false;
  EXPECT_EQ(clock.now(), 1'980us);
}

TEST(TheSlowClock, NeverGoesBackwardsWhicheverCountItIsReadAt) {
  std::mt19937 random{fantail::test::seed(20'260'301)};
  RegisterWorld world;
  FakeSysTick systick{world};
  Clock clock{systick.timer, systick.system, 16'000'000};
  systick.handler = [&clock] { clock.tick(); };
  systick.access_counts = [&random] { return random() % 9; };
  Microseconds before{};
  for (int reading = 0; reading < 3'000; ++reading) {
    // Mostly around the end of a millisecond, where the timer turns over, often with the interrupt held back.
    const auto left = 16'000 - systick.counts() % 16'000;
    systick.pass(left > 40 ? left - random() % 40 : random() % 20);
    systick.processor.masked = random() % 2 == 0;
    systick.latency_counts = 12 + static_cast<std::uint32_t>(random() % 200);
    const std::uint64_t begin = systick.counts();
    const Microseconds now = clock.now();
    const std::uint64_t end = systick.counts();
    ASSERT_GE(now, before) << "reading " << reading;
    // One count from the clearing of the timer to its first LOAD belongs to no millisecond.
    ASSERT_GE(now.count(), static_cast<std::int64_t>((begin - 1) / 16)) << "reading " << reading;
    ASSERT_LE(now.count(), static_cast<std::int64_t>(end / 16)) << "reading " << reading;
    before = now;
    systick.processor.masked = false;
    systick.pass(300);
  }
}

TEST_F(TheClock, TheLoopBeginsWithEachMillisecond) {
  pass(3'400us);
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  EXPECT_EQ(clock.now(), 4'000us);
  pass(600us);
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  EXPECT_EQ(clock.now(), 5'000us);
}

TEST_F(TheClock, ALoopThatIsLateBeginsAtOnceAndSaysWhatItMissed) {
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  pass(1'200us);
  EXPECT_EQ(clock.wait_for_tick(), 0U) << "late, but each millisecond has had its turn";
  EXPECT_EQ(clock.now(), 2'200us);
  pass(3'300us);
  EXPECT_EQ(clock.wait_for_tick(), 2U) << "those that began at 3 and at 4 ms";
  EXPECT_EQ(clock.now(), 5'500us);
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  EXPECT_EQ(clock.now(), 6'000us);
}

TEST_F(TheClock, AnInterruptJustBeforeTheSleepIsNotSleptThrough) {
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  // The millisecond ends in the very moment in which the loop goes to sleep, and the processor was told to mask.
  const auto sleep = systick.processor.on_wait_for_interrupt;
  int sleeps = 0;
  systick.processor.on_wait_for_interrupt = [&] {
    EXPECT_TRUE(systick.processor.masked);
    sleeps += 1;
    pass(1'000us);
    sleep();
  };
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  EXPECT_EQ(sleeps, 1);
}

TEST_F(TheClock, OtherInterruptsDoNotEndTheWait) {
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  int sleeps = 0;
  systick.processor.on_wait_for_interrupt = [&] {
    sleeps += 1;
    pass(300us);  // something on the bus
  };
  EXPECT_EQ(clock.wait_for_tick(), 0U);
  EXPECT_EQ(sleeps, 4);
}

TEST_F(TheClock, AfterTheWaitInterruptsAreServed) {
  static_cast<void>(clock.wait_for_tick());
  EXPECT_FALSE(systick.processor.masked);
}

using test::FakeClocks;
using test::RegisterWorld;

struct StartClocks : testing::Test {
  RegisterWorld world{};
  FakeClocks clocks{world};
  ClockTree start() { return start_clocks(clocks.rcc, clocks.flash, clocks.pwr); }

  void expect_what_runs(const Frequencies& told) const {
    EXPECT_EQ(told.core_hz, clocks.core_hz());
    EXPECT_EQ(told.apb1_hz, clocks.apb1_hz());
    EXPECT_EQ(told.apb2_hz, clocks.apb2_hz());
    EXPECT_EQ(told.apb1_timers_hz, clocks.apb1_timers_hz());
    EXPECT_EQ(told.apb2_timers_hz, clocks.apb2_timers_hz());
    EXPECT_FALSE(clocks.ever_too_fast());
  }
};

TEST_F(StartClocks, RunsAt168MegahertzFromTheCrystal) {
  const ClockTree tree = start();
  EXPECT_TRUE(tree.faults.none());
  EXPECT_EQ(tree.frequencies.core_hz, 168'000'000U);
  EXPECT_EQ(tree.frequencies.apb1_hz, 42'000'000U);
  EXPECT_EQ(tree.frequencies.apb2_hz, 84'000'000U);
  EXPECT_EQ(tree.frequencies.apb1_timers_hz, 84'000'000U);
  EXPECT_EQ(tree.frequencies.apb2_timers_hz, 168'000'000U);
  expect_what_runs(tree.frequencies);
  EXPECT_EQ(clocks.rng_hz(), 48e6);
  EXPECT_TRUE(clocks.crystal_is_watched());
}

TEST_F(StartClocks, OnlyTheHighestBrownOutLevelIsEnoughForThisSpeed) {
  for (const std::uint32_t level : {0U, 1U, 2U, 3U}) {  // 0 is level 3, 3 is off: RM0090 section 3.9.6
    RegisterWorld::poke(clocks.flash.optcr, 0x0FFFAAE0U | level << 2U);
    EXPECT_EQ(start().faults.has(BoardFault::brown_out_level), level != 0);
  }
}

TEST_F(StartClocks, TheFlashHasFiveWaitStatesPrefetchAndBothCaches) {
  static_cast<void>(start());
  EXPECT_EQ(clocks.acr(), 0x705U);
}

TEST_F(StartClocks, TheRegulatorIsAtScaleOneAndItsOwnClockIsOn) {
  static_cast<void>(start());
  EXPECT_EQ(RegisterWorld::peek(clocks.pwr.cr) >> 14U & 1U, 1U);
  EXPECT_EQ(RegisterWorld::peek(clocks.rcc.apb1enr) >> 28U & 1U, 1U);
}

TEST_F(StartClocks, ACrystalThatNeverStartsIsAFaultAndTheInternalOscillatorFeedsThePll) {
  clocks.crystal_starts = false;
  const ClockTree tree = start();
  EXPECT_TRUE(tree.faults.has(BoardFault::crystal_failed));
  EXPECT_FALSE(tree.faults.has(BoardFault::clock_failed));
  EXPECT_EQ(tree.frequencies.core_hz, 168'000'000U);
  expect_what_runs(tree.frequencies);
  EXPECT_EQ(clocks.rng_hz(), 48e6);
  EXPECT_FALSE(clocks.crystal_is_on());
  EXPECT_FALSE(clocks.crystal_is_watched());
}

TEST_F(StartClocks, APllThatDoesNotLockLeavesTheInternalSixteenMegahertz) {
  clocks.pll_locks = false;
  const ClockTree tree = start();
  EXPECT_TRUE(tree.faults.has(BoardFault::clock_failed));
  EXPECT_FALSE(tree.faults.has(BoardFault::crystal_failed));
  EXPECT_EQ(tree.frequencies.core_hz, 16'000'000U);
  EXPECT_EQ(tree.frequencies.apb1_timers_hz, 16'000'000U);
  EXPECT_EQ(tree.frequencies.apb2_timers_hz, 16'000'000U);
  expect_what_runs(tree.frequencies);
  EXPECT_FALSE(clocks.pll_is_on());
}

TEST_F(StartClocks, AFlashThatStaysFastIsNotReadAt168Megahertz) {
  clocks.flash_takes_wait_states = false;
  const ClockTree tree = start();
  EXPECT_TRUE(tree.faults.has(BoardFault::clock_failed));
  EXPECT_EQ(tree.frequencies.core_hz, 16'000'000U);
  expect_what_runs(tree.frequencies);
}

TEST_F(StartClocks, ASwitchThatStaysWhereItIsLeavesTheInternalSixteenMegahertz) {
  clocks.switch_works = false;
  const ClockTree tree = start();
  EXPECT_TRUE(tree.faults.has(BoardFault::clock_failed));
  expect_what_runs(tree.frequencies);
}

TEST(StartClocksOnNothing, RegistersThatReadZeroAreTwoFaultsAndNoHang) {
  RegisterWorld world;
  registers::Rcc rcc{};
  registers::FlashInterface flash{};
  registers::Pwr pwr{};
  for (registers::Register* const place : {&rcc.cr, &rcc.cfgr, &rcc.apb1enr, &flash.acr, &pwr.cr}) {
    world.on_write(*place, [](std::uint32_t) {});
  }
  const ClockTree tree = start_clocks(rcc, flash, pwr);
  EXPECT_TRUE(tree.faults.has(BoardFault::crystal_failed));
  EXPECT_TRUE(tree.faults.has(BoardFault::clock_failed));
  EXPECT_EQ(tree.frequencies.core_hz, 16'000'000U);
  EXPECT_LT(world.accesses(), 30'000U);
}

TEST(EnablePeripherals, GivesAClockToWhatTheBoardUsesAndKeepsTheOthers) {
  registers::Rcc rcc{};
  RegisterWorld::poke(rcc.ahb1enr, 0x00100000);  // reset value: the core-coupled memory
  enable_peripherals(rcc);
  EXPECT_EQ(RegisterWorld::peek(rcc.ahb1enr), 0x00100007U);  // RM0090 section 7.3.10
  EXPECT_EQ(RegisterWorld::peek(rcc.ahb2enr), 0x00000040U);
  EXPECT_EQ(RegisterWorld::peek(rcc.apb1enr), 0x1200C001U);
  EXPECT_EQ(RegisterWorld::peek(rcc.apb2enr), 0x00001113U);
}

}  // namespace

}  // namespace fantail::hal::stm32f4
