// SPDX-License-Identifier: MIT
// The same frames in the words of can-utils, which was not written by us.

#include "hal/linux/can_bus.hpp"
#include "linux/shell.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using hal::CanFrame;
using hal::on_linux::CanBus;
using hal::on_linux::CanFilter;

class LinuxCanTools : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
};

TEST_F(LinuxCanTools, CandumpReadsWhatWeSend) {
  Background dump = candump("vcan0", 4);
  CanBus bus{"vcan0"};
  ASSERT_TRUE(bus.send({.id = 0x123, .length = 3, .data = {0xDE, 0xAD, 0x01}}));
  ASSERT_TRUE(bus.send({.id = 0x1ABCDEF0, .extended = true, .length = 1, .data = {0x42}}));
  ASSERT_TRUE(bus.send({.id = 0x321, .remote = true, .length = 2}));
  ASSERT_TRUE(bus.send({.id = 0x001}));
  EXPECT_EQ(dump.output(),
            "vcan0 123#DEAD01\n"
            "vcan0 1ABCDEF0#42\n"
            "vcan0 321#R2\n"
            "vcan0 001#\n");
}

TEST_F(LinuxCanTools, WeReadWhatCansendSends) {
  const std::array everything{CanFilter{}, CanFilter{.extended = true}};
  CanBus bus{"vcan0", everything};
  must("cansend vcan0 123#DEAD01");
  must("cansend vcan0 1ABCDEF0#42");
  must("cansend vcan0 321#R2");
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x123, .length = 3, .data = {0xDE, 0xAD, 0x01}}));
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x1ABCDEF0, .extended = true, .length = 1, .data = {0x42}}));
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x321, .remote = true, .length = 2}));
}

TEST_F(LinuxCanTools, FramesOfCanFdAndInjectedErrorsAreNotHandedOut) {
  CanBus bus{"vcan0"};
  must("cansend vcan0 123##1112233445566778899AABBCC");  // CAN FD, 12 bytes
  must("cansend vcan0 20000020#0000000000000000");       // CAN_ERR_FLAG | CAN_ERR_ACK
  must("cansend vcan0 7FF#EE");
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x7FF, .length = 1, .data = {0xEE}}));
  EXPECT_EQ(bus.counters().received, 1U);
  EXPECT_EQ(bus.counters().errors, 1U);
  EXPECT_EQ(bus.state(), hal::CanState::error_active);
}

}  // namespace
}  // namespace fantail::test
