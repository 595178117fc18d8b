// SPDX-License-Identifier: MIT
#include "hal/stm32f4/pin.hpp"

#include <gtest/gtest.h>

#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

TEST(Pin, IsSetAndResetByItsOwnBitsAndNoOthers) {
  registers::Gpio port{};
  Pin pin{port, 12};
  pin.high();
  EXPECT_EQ(RegisterWorld::peek(port.bsrr), 1U << 12U);
  pin.low();
  EXPECT_EQ(RegisterWorld::peek(port.bsrr), 1U << 28U);
}

TEST(Pin, IsReadFromThePortsInput) {
  registers::Gpio port{};
  const Pin pin{port, 3};
  EXPECT_FALSE(pin.is_high());
  RegisterWorld::poke(port.idr, 1U << 3U);
  EXPECT_TRUE(pin.is_high());
}

TEST(WaitFor, GivesUpAfterSoManyLooks) {
  RegisterWorld world;
  registers::Gpio port{};
  int looks = 0;
  world.on_read(port.idr, [&looks] { return ++looks < 5 ? 0U : 1U; });
  EXPECT_FALSE(registers::wait_for(port.idr, 1, 1, 4));
  EXPECT_EQ(looks, 4);
  EXPECT_TRUE(registers::wait_for(port.idr, 1, 1, 4));
}

}  // namespace
}  // namespace fantail::hal::stm32f4
