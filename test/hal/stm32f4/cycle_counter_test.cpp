// SPDX-License-Identifier: MIT
#include "hal/stm32f4/cycle_counter.hpp"

#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

/// Armv7-M C1.8: it answers while trace is enabled, and counts while that is so and it was told to.
struct FakeDwt {
  registers::Dwt registers{};
  registers::CoreDebug debug{};
  std::uint32_t cycles = 0xFFFFFF00U;  // after a reset it may stand anywhere
  bool there = true;
  std::uint32_t control = 0x40000000U;  // four comparators

  explicit FakeDwt(RegisterWorld& world) {
    world.on_write(registers.ctrl, [this](std::uint32_t value) { control = enabled() ? value : control; });
    world.on_read(registers.ctrl, [this] { return enabled() ? control : 0U; });
    world.on_read(registers.cyccnt, [this] { return enabled() && (control & 1U) != 0 ? cycles : 0U; });
  }
  [[nodiscard]] bool enabled() const { return there && (RegisterWorld::peek(debug.demcr) >> 24U & 1U) != 0; }
};

struct TheCycleCounter : testing::Test {
  RegisterWorld world{};
  FakeDwt dwt{world};
  void work(CycleCounter& counter, std::uint32_t cycles) {
    counter.begin();
    dwt.cycles += cycles;
    counter.end();
  }
};

TEST_F(TheCycleCounter, TellsTheLongestPieceOfWorkSinceItWasAskedAlsoWhereItWrapsAround) {
  CycleCounter counter{dwt.registers, dwt.debug};
  work(counter, 40'000);
  work(counter, 90'000);
  work(counter, 10'000);
  EXPECT_EQ(counter.take_longest(), 90'000U);
  EXPECT_EQ(counter.take_longest(), std::nullopt);
  work(counter, 20'000);
  EXPECT_EQ(counter.take_longest(), 20'000U);
}

TEST_F(TheCycleCounter, WhatLiesBetweenTwoPiecesOfWorkIsNone) {
  CycleCounter counter{dwt.registers, dwt.debug};
  counter.end();
  EXPECT_EQ(counter.take_longest(), std::nullopt);
  work(counter, 100);
  dwt.cycles += 1'000'000;
  counter.end();
  EXPECT_EQ(counter.take_longest(), 100U);
}

TEST_F(TheCycleCounter, LeavesTheOtherBitsOfItsUnitsAsTheyWere) {
  RegisterWorld::poke(dwt.debug.demcr, 0x00000001U);
  const CycleCounter counter{dwt.registers, dwt.debug};
  EXPECT_EQ(RegisterWorld::peek(dwt.debug.demcr), 0x01000001U);
  EXPECT_EQ(dwt.control, 0x40000001U);
}

TEST_F(TheCycleCounter, AProcessorThatReadsZeroOrSaysThatItHasNoneHasNoNumber) {
  dwt.there = false;
  CycleCounter emulated{dwt.registers, dwt.debug};
  work(emulated, 100);
  EXPECT_EQ(emulated.take_longest(), std::nullopt);

  dwt.there = true;
  dwt.control = 1U << 25U;
  CycleCounter without{dwt.registers, dwt.debug};
  work(without, 100);
  EXPECT_EQ(without.take_longest(), std::nullopt);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
