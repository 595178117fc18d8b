// SPDX-License-Identifier: MIT
#include "hal/stm32f4/pin.hpp"

#include <thread>

#include "hal/stm32f4/interrupt_queue.hpp"
#include "hal/stm32f4/pin_setup.hpp"
#include "register_world.hpp"
#include "test.hpp"

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

TEST(InterruptQueue, GivesBackInOrderAndRefusesWhatIsTooMuch) {
  InterruptQueue<int, 4> queue;
  EXPECT_FALSE(queue.pop());
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(queue.push(i));
  }
  EXPECT_TRUE(queue.full());
  EXPECT_FALSE(queue.push(4));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(queue.pop(), i);
  }
  EXPECT_FALSE(queue.pop());
}

TEST(InterruptQueue, SaysHowManyItDropped) {
  InterruptQueue<int, 4> queue;
  queue.push(1);
  queue.push(2);
  EXPECT_EQ(queue.drop_all(), 2U);
  EXPECT_FALSE(queue.pop());
}

// Two cores are harder on it than a core and its interrupts.
TEST(InterruptQueue, LosesNothingAndTearsNothingBetweenTwoThreads) {
  struct Element {
    std::uint32_t number;
    std::uint32_t inverse;
  };
  constexpr std::uint32_t count = 50'000;
  InterruptQueue<Element, 8> queue;
  std::thread producer{[&queue] {
    for (std::uint32_t i = 0; i < count;) {
      if (queue.push({i, ~i})) {
        i += 1;
      } else {
        std::this_thread::yield();
      }
    }
  }};
  std::uint32_t wrong = 0;
  for (std::uint32_t expected = 0; expected < count;) {
    if (const auto element = queue.pop()) {
      wrong += element->number == expected && element->inverse == ~expected ? 0U : 1U;
      expected += 1;
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
}

}  // namespace

}  // namespace fantail::hal::stm32f4
