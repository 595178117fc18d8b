// SPDX-License-Identifier: MIT
#include "hal/stm32f4/edge_timer.hpp"

#include <gtest/gtest.h>

#include "fake_capture.hpp"

namespace fantail::hal::stm32f4 {
namespace {

TEST(EdgeTimer, CountsMicrosecondsAndKeepsTheLastEdge) {
  for (const std::uint32_t hz : {84'000'000U, 16'000'000U}) {
    test::RegisterWorld world;
    test::FakeClock clock;
    std::optional<test::LineEdge> rose;
    test::FakeCapture capture{world, clock, static_cast<double>(hz), [&] { return rose; }};
    EdgeTimer timer{capture.registers, hz};
    ASSERT_TRUE(capture.captures());
    EXPECT_EQ(timer.last_edge(), 0U);
    rose = {Microseconds{12'345}, 1};
    EXPECT_FALSE(timer.take_overrun());
    clock.time = Microseconds{13'000};
    EXPECT_EQ(timer.last_edge(), 12'345U);
    EXPECT_EQ(timer.now(), 13'000U);
    rose = {Microseconds{12'900}, 2};
    EXPECT_FALSE(timer.take_overrun());
    rose = {Microseconds{12'950}, 3};
    EXPECT_TRUE(timer.take_overrun());
    EXPECT_FALSE(timer.take_overrun());
    // IC4F: eight samples at the timer's clock (RM0090 section 18.4.8).
    EXPECT_EQ(test::RegisterWorld::peek(capture.registers.ccmr[1]), 0x3100U);
    EXPECT_EQ(test::RegisterWorld::peek(capture.registers.ccer), 0x1000U);
  }
}

}  // namespace
}  // namespace fantail::hal::stm32f4
