// SPDX-License-Identifier: MIT
#include "hal/stm32f4/clock_tree.hpp"

#include <gtest/gtest.h>

#include "fake_clocks.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

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
