// SPDX-License-Identifier: MIT
#include "hal/stm32f4/pin_setup.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

TEST(PinSetup, WritesThePinsOwnBitsAndNoOthers) {
  registers::Gpio port{};
  // As port A is after a reset: the probe's pins 13 to 15 (RM0090 section 8.4.1).
  RegisterWorld::poke(port.moder, 0xA8000000U);
  RegisterWorld::poke(port.pupdr, 0x64000000U);
  set_up(port, {.port = 'A',
                .number = 9,
                .mode = PinMode::alternate,
                .alternate = 7,
                .pull = PinPull::up,
                .speed = PinSpeed::fast});
  EXPECT_EQ(RegisterWorld::peek(port.moder), 0xA8000000U | 2U << 18U);
  EXPECT_EQ(RegisterWorld::peek(port.pupdr), 0x64000000U | 1U << 18U);
  EXPECT_EQ(RegisterWorld::peek(port.ospeedr), 2U << 18U);
  EXPECT_EQ(RegisterWorld::peek(port.afr[0]), 0U);
  EXPECT_EQ(RegisterWorld::peek(port.afr[1]), 7U << 4U);
}

TEST(PinSetup, AnOutputHasItsLevelBeforeItDrives) {
  RegisterWorld world;
  registers::Gpio port{};
  std::vector<char> order;
  std::uint32_t level = 0;
  world.on_write(port.bsrr, [&](std::uint32_t value) {
    level = value;
    order.push_back('l');
  });
  world.on_write(port.moder, [&](std::uint32_t) { order.push_back('m'); });
  set_up(port, {.port = 'A', .number = 4, .mode = PinMode::output, .high = true});
  EXPECT_EQ(level, 1U << 4U);
  EXPECT_EQ(order, (std::vector<char>{'l', 'm'}));
}

}  // namespace
}  // namespace fantail::hal::stm32f4
