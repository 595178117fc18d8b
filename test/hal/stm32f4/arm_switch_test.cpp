// SPDX-License-Identifier: MIT
#include "hal/stm32f4/arm_switch.hpp"

#include <random>

#include <gtest/gtest.h>

#include "register_world.hpp"
#include "seed.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

struct TheArmSwitch : testing::Test {
  registers::Gpio port{};
  ArmSwitch arm_switch{Pin{port, 3}};
  void ticks(int count, bool level) {
    for (int tick = 0; tick < count; ++tick) {
      RegisterWorld::poke(port.idr, level ? 1U << 3U : 0);
      arm_switch.update();
    }
  }
};

TEST_F(TheArmSwitch, IsOpenAtPowerUpEvenWhenTheContactIsClosed) {
  EXPECT_FALSE(arm_switch.closed());
  ticks(49, true);
  EXPECT_FALSE(arm_switch.closed());
}

TEST_F(TheArmSwitch, ClosesAfterFiftyTicksAtTheSameLevel) {
  ticks(50, true);
  EXPECT_TRUE(arm_switch.closed());
}

TEST_F(TheArmSwitch, OpensAfterFiftyTicksToo) {
  ticks(50, true);
  ticks(49, false);
  EXPECT_TRUE(arm_switch.closed());
  ticks(1, false);
  EXPECT_FALSE(arm_switch.closed());
}

TEST_F(TheArmSwitch, OneTickAtTheOldLevelBeginsAllOver) {
  ticks(49, true);
  ticks(1, false);
  ticks(49, true);
  EXPECT_FALSE(arm_switch.closed());
  ticks(1, true);
  EXPECT_TRUE(arm_switch.closed());
}

TEST_F(TheArmSwitch, ABouncingContactIsNeitherClosedNorOpened) {
  std::mt19937 random{fantail::test::seed(7)};
  const auto bounce = [&] {
    for (int spike = 0; spike < 200; ++spike) {
      ticks(static_cast<int>(random() % 50), true);
      ticks(1 + static_cast<int>(random() % 49), false);
    }
  };
  bounce();
  EXPECT_FALSE(arm_switch.closed());
  ticks(50, true);
  for (int spike = 0; spike < 200; ++spike) {
    ticks(static_cast<int>(random() % 50), false);
    ticks(1, true);
    ASSERT_TRUE(arm_switch.closed());
  }
}

}  // namespace
}  // namespace fantail::hal::stm32f4
