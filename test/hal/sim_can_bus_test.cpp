// SPDX-License-Identifier: MIT

#include "hal/sim/can_bus.hpp"
#include "test.hpp"

namespace fantail::hal::sim {
namespace {

TEST(CanWire, WhatOneNodeSendsAllOthersReceiveAndNotItself) {
  CanWire wire;
  CanBus sender{wire};
  CanBus first{wire};
  CanBus second{wire};
  EXPECT_TRUE(sender.send({.id = 7}));
  EXPECT_EQ(first.receive(), CanFrame{.id = 7});
  EXPECT_EQ(second.receive(), CanFrame{.id = 7});
  EXPECT_EQ(sender.receive(), std::nullopt);
}

TEST(CanWire, ANodeThatIsGoneLeavesTheOthersConnectedAndItsPlaceFree) {
  CanWire wire;
  std::optional<CanBus> gone{wire};
  CanBus sender{wire};
  CanBus stays{wire};
  gone.reset();
  EXPECT_TRUE(sender.send({.id = 1}));
  EXPECT_EQ(stays.receive(), CanFrame{.id = 1});
  CanBus comes{wire};
  EXPECT_TRUE(sender.send({.id = 2}));
  EXPECT_EQ(stays.receive(), CanFrame{.id = 2});
  EXPECT_EQ(comes.receive(), CanFrame{.id = 2});
}

TEST(CanBus, FramesThatArePassedOverCountAsReceivedAndDoNotComeAgain) {
  CanWire wire;
  CanBus sender{wire};
  CanBus receiver{wire};
  for (std::uint32_t id = 1; id <= 3; ++id) {
    EXPECT_TRUE(sender.send({.id = id}));
  }
  receiver.pass_over();
  EXPECT_EQ(receiver.counters().received, 3U);
  EXPECT_EQ(receiver.receive(), std::nullopt);
  EXPECT_TRUE(sender.send({.id = 4}));
  EXPECT_EQ(receiver.receive(), CanFrame{.id = 4});
}

}  // namespace
}  // namespace fantail::hal::sim
