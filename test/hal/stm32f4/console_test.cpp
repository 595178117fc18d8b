// SPDX-License-Identifier: MIT
#include "hal/stm32f4/console.hpp"

#include "fake_usart.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeUsart;
using test::RegisterWorld;

constexpr std::uint32_t bus_hz = 84'000'000;
constexpr std::uint8_t usart1_interrupt = 37;

struct TheConsole : testing::Test {
  RegisterWorld world{};
  FakeUsart usart{world};
  Console console{usart.port, InterruptLine{usart.set_pending, usart1_interrupt}, bus_hz};
  TheConsole() {
    usart.handler = [this] { console.on_interrupt(); };
  }
  void pass_bytes(int count) {
    for (int i = 0; i < count; ++i) {
      usart.pass_byte();
    }
  }
  void arrive(std::uint8_t byte) {
    usart.arrive(byte);
    usart.serve();
  }
  std::string taken() {
    std::string result;
    while (const auto byte = console.take()) {
      result += static_cast<char>(*byte);
    }
    return result;
  }
};

TEST_F(TheConsole, TheBaudRateIsWithinAPercentAtEachClockAndSpeedInUse) {
  EXPECT_NEAR(usart.baud(bus_hz), 115'200, 1'152);
  const Console slow{usart.port, InterruptLine{usart.set_pending, usart1_interrupt}, 16'000'000};
  EXPECT_NEAR(usart.baud(16e6), 115'200, 1'152);
  const Console fast{usart.port, InterruptLine{usart.set_pending, usart1_interrupt}, bus_hz, 921'600};
  EXPECT_NEAR(usart.baud(bus_hz), 921'600, 9'216);
}

TEST_F(TheConsole, ALineLeavesByteByByteWithoutAnybodyWaiting) {
  console.write("safe\n");
  EXPECT_EQ(usart.wire, "");
  pass_bytes(10);
  EXPECT_EQ(usart.wire, "safe\n");
}

TEST_F(TheConsole, LinesFollowEachOtherInOrder) {
  console.write("one ");
  pass_bytes(2);
  console.write("two ");
  pass_bytes(20);
  console.write("three");
  pass_bytes(20);
  EXPECT_EQ(usart.wire, "one two three");
}

TEST_F(TheConsole, WhatDoesNotFitIsDroppedAndCountedAndTheRestIsWhole) {
  const std::string first(1'000, 'a');
  console.write(first);
  console.write(std::string(100, 'b'));
  EXPECT_EQ(console.dropped(), 76U);
  pass_bytes(1'100);
  EXPECT_EQ(usart.wire, first + std::string(24, 'b'));
  console.write("later");
  pass_bytes(10);
  EXPECT_TRUE(usart.wire.ends_with("later"));
}

TEST_F(TheConsole, AnIdlePortInterruptsNobody) {
  console.write("several");
  pass_bytes(10);
  const std::uint32_t calls = usart.handler_calls;
  pass_bytes(50);
  EXPECT_EQ(usart.handler_calls, calls);
}

TEST_F(TheConsole, InTheEmulatorWhereAnEmptyTransmitterInterruptsNobodyEverythingIsSent) {
  usart.is_emulated = true;
  const std::string text(900, 'e');
  console.write(text);
  usart.serve();
  EXPECT_EQ(usart.wire, text);
}

TEST_F(TheConsole, BytesThatArriveAreTakenInOrder) {
  EXPECT_FALSE(console.take());
  arrive('a');
  arrive(0);
  arrive(0xFF);
  EXPECT_EQ(taken(), std::string("a\0\xFF", 3));
  EXPECT_EQ(console.overruns(), 0U);
}

TEST_F(TheConsole, BytesThatNobodyTakesAreCountedWhenTheQueueIsFull) {
  for (int i = 0; i < 515; ++i) {
    arrive(static_cast<std::uint8_t>(i));
  }
  EXPECT_EQ(console.overruns(), 3U);
  EXPECT_EQ(taken().size(), 512U);
  arrive('z');
  EXPECT_EQ(taken(), "z");
}

TEST_F(TheConsole, AHandlerThatComesTooLateIsAnOverrunAndKeepsTheOlderByte) {
  usart.arrive('a');
  usart.arrive('b');
  usart.serve();
  EXPECT_EQ(taken(), "a");
  EXPECT_EQ(console.overruns(), 1U);
  EXPECT_FALSE(usart.interrupts());
}

TEST_F(TheConsole, AnOverrunWithoutAByteDoesNotInterruptForEver) {
  usart.lose_one();
  usart.serve();
  EXPECT_FALSE(usart.interrupts());
  EXPECT_EQ(console.overruns(), 1U);
  EXPECT_EQ(taken(), "");
}

TEST_F(TheConsole, BothDirectionsAtOnceLoseNothing) {
  std::string expected;
  for (int i = 0; i < 300; ++i) {
    const char byte = static_cast<char>('a' + i % 26);
    console.write(std::string(1, byte));
    usart.arrive(static_cast<std::uint8_t>(byte));
    usart.pass_byte();
    expected += byte;
  }
  pass_bytes(5);
  EXPECT_EQ(usart.wire, expected);
  EXPECT_EQ(taken(), expected);
  EXPECT_EQ(console.overruns() + console.dropped(), 0U);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
