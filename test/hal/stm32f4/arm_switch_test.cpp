// SPDX-License-Identifier: MIT
#include "hal/sim/devices.hpp"
#include "hal/stm32f4/contact.hpp"
#include "register_world.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

struct TheArmSwitch : testing::Test {
  registers::Gpio port{};
  Contact arm_switch{Pin{port, 3}, ClosedLevel::high};
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

TEST_F(TheArmSwitch, IsNeitherClosedNorOpenBeforeItHasSettled) {
  EXPECT_FALSE(arm_switch.open());
  ticks(49, true);
  ticks(49, false);
  EXPECT_FALSE(arm_switch.open() || arm_switch.closed());
  ticks(1, false);
  EXPECT_TRUE(arm_switch.open());
  ticks(49, true);
  EXPECT_TRUE(arm_switch.open()) << "it bounces";
  ticks(1, true);
  EXPECT_FALSE(arm_switch.open());
}

// A board that is reset with its switch closed has not seen it open: nobody has closed it since.
TEST_F(TheArmSwitch, ThatIsClosedAtPowerUpIsNeverOpen) {
  for (int tick = 0; tick < 200; ++tick) {
    ticks(1, true);
    ASSERT_FALSE(arm_switch.open());
  }
}

// The abort contact: the pin is pulled up, and a wire that is off leaves it open.
TEST(ContactToGround, IsClosedWhileThePinIsLow) {
  registers::Gpio port{};
  Contact contact{Pin{port, 1}, ClosedLevel::low};
  for (const bool low : {true, false, true}) {
    RegisterWorld::poke(port.idr, low ? 0 : 1U << 1U);
    for (int tick = 0; tick < 50; ++tick) {
      contact.update();
    }
    EXPECT_EQ(contact.closed(), low);
    EXPECT_EQ(contact.open(), !low);
  }
}

// That of a node, of a simulated flight and of the emulator, from power-up on, at the same contacts.
TEST_F(TheArmSwitch, ChangesInTheSameTickAsTheSimulatedOne) {
  std::mt19937 random{fantail::test::seed(8)};
  sim::WorldSide world;
  sim::Contact simulated{world.arm_switch_closed};
  int changes = 0;
  for (int stretch = 0; stretch < 2'000; ++stretch) {
    const bool level = random() % 2 == 0;
    const auto longest = std::array{3U, 49U, 52U, 200U}[random() % 4];
    for (auto left = 1 + random() % longest; left > 0; --left) {
      const bool before = arm_switch.closed();
      ticks(1, level);
      world.arm_switch_closed = level;
      simulated.update();
      ASSERT_EQ(simulated.closed(), arm_switch.closed()) << stretch;
      ASSERT_EQ(simulated.open(), arm_switch.open()) << stretch;
      changes += before != arm_switch.closed() ? 1 : 0;
    }
  }
  EXPECT_GT(changes, 100);
}

// A button or a wire to ground, with a resistor inside that pulls up.
TEST(TheAbortContact, IsClosedWhileItsPinIsLowAndOpenWhenTheWireIsOff) {
  registers::Gpio port{};
  Contact contact{Pin{port, 1}, ClosedLevel::low};
  const auto ticks = [&](bool high) {
    RegisterWorld::poke(port.idr, high ? 1U << 1U : 0);
    for (int tick = 0; tick < 50; ++tick) {
      EXPECT_TRUE(!contact.open() || !contact.closed());
      contact.update();
    }
  };
  EXPECT_FALSE(contact.open() || contact.closed()) << "not known yet";
  ticks(true);
  EXPECT_TRUE(contact.open() && !contact.closed());
  ticks(false);
  EXPECT_TRUE(contact.closed() && !contact.open());
  ticks(true);
  EXPECT_TRUE(contact.open() && !contact.closed());
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
