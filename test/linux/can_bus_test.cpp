// SPDX-License-Identifier: MIT
#include "hal/linux/can_bus.hpp"

#include "linux/shell.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using hal::CanFrame;
using hal::CanState;
using hal::on_linux::CanBus;
using std::chrono::milliseconds;

class LinuxCanBus : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
};

CanFrame numbered(std::uint32_t number) {
  return {.id = 0x100 + number % 0x100,
          .length = 4,
          .data = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U), 0xA5, 0x5A}};
}

TEST_F(LinuxCanBus, CarriesAFrameToAnotherBusObjectAndBack) {
  CanBus here{"vcan0"};
  CanBus there{"vcan0"};
  const CanFrame question{.id = 0x7FF, .length = 8, .data = {1, 2, 3, 4, 5, 6, 7, 0xFF}};
  const CanFrame answer{.id = 0, .length = 0};
  ASSERT_TRUE(here.send(question));
  EXPECT_EQ(next_frame(there), question);
  ASSERT_TRUE(there.send(answer));
  EXPECT_EQ(next_frame(here), answer);
  EXPECT_EQ(here.state(), CanState::error_active);
  EXPECT_EQ(here.counters().sent, 1U);
  EXPECT_EQ(here.counters().received, 1U);
  EXPECT_EQ(here.counters().unsent + here.counters().overrun + here.counters().errors, 0U);
}

TEST_F(LinuxCanBus, DoesNotHearItsOwnFrames) {
  CanBus here{"vcan0"};
  CanBus there{"vcan0"};
  ASSERT_TRUE(here.send(numbered(1)));
  ASSERT_TRUE(next_frame(there));  // a virtual bus is one call deep: what has arrived there would have arrived here
  EXPECT_FALSE(here.receive());
}

TEST_F(LinuxCanBus, TwoInterfacesAreTwoBuses) {
  CanBus first{"vcan0"};
  CanBus second{"vcan1"};
  CanBus witness{"vcan0"};
  ASSERT_TRUE(first.send(numbered(1)));
  ASSERT_TRUE(next_frame(witness));
  EXPECT_FALSE(second.receive());
}

TEST_F(LinuxCanBus, KeepsTheOrderOfAThousandFrames) {
  CanBus here{"vcan0"};
  CanBus there{"vcan0"};
  for (std::uint32_t i = 0; i < 1000; ++i) {
    ASSERT_TRUE(here.send(numbered(i)));
    if (i % 50 == 49) {
      for (std::uint32_t j = i - 49; j <= i; ++j) {
        ASSERT_EQ(next_frame(there), numbered(j));
      }
    }
  }
  EXPECT_EQ(there.counters().received, 1000U);
  EXPECT_EQ(there.counters().overrun, 0U);
}

TEST_F(LinuxCanBus, WithoutAFrameItSaysSoAtOnceAndWaitsAsLongAsAsked) {
  CanBus bus{"vcan0"};
  EXPECT_FALSE(bus.receive());
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(bus.wait(milliseconds{50}));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds{50});
  EXPECT_FALSE(bus.wait(milliseconds{0}));
  EXPECT_FALSE(bus.wait(milliseconds{-5}));
}

TEST_F(LinuxCanBus, AFrameEndsTheWait) {
  CanBus here{"vcan0"};
  CanBus there{"vcan0"};
  ASSERT_TRUE(there.send(numbered(3)));
  EXPECT_TRUE(here.wait(std::chrono::hours{1})) << "it has waited to the end";
  EXPECT_EQ(here.receive(), numbered(3));
}

TEST_F(LinuxCanBus, RefusesAndCountsFramesThatCannotExist) {
  CanBus bus{"vcan0"};
  EXPECT_FALSE(bus.send({.id = 0x800, .length = 1}));
  EXPECT_FALSE(bus.send({.id = 0x20000000, .extended = true, .length = 1}));
  EXPECT_FALSE(bus.send({.id = 1, .length = 9}));
  EXPECT_EQ(bus.counters().unsent, 3U);
  EXPECT_EQ(bus.counters().sent, 0U);
}

TEST_F(LinuxCanBus, CountsWhatArrivedAndFoundTheBufferFull) {
  CanBus slow{"vcan0"};
  CanBus fast{"vcan0"};
  std::uint32_t sent = 0;
  // Far more than any buffer holds. The count comes with the first frame that arrives after the loss.
  while (sent < 60'000) {
    ASSERT_TRUE(fast.send(numbered(sent)));
    ++sent;
  }
  while (slow.receive()) {
  }
  ASSERT_TRUE(fast.send(numbered(++sent)));
  ASSERT_TRUE(next_frame(slow));
  EXPECT_GT(slow.counters().overrun, 0U);
  EXPECT_EQ(slow.counters().received + slow.counters().overrun, fast.counters().sent);
}

}  // namespace
}  // namespace fantail::test
