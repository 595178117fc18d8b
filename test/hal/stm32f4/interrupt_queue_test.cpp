// SPDX-License-Identifier: MIT
#include "hal/stm32f4/interrupt_queue.hpp"

#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace fantail::hal::stm32f4 {
namespace {

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
