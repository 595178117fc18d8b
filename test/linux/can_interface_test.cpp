// SPDX-License-Identifier: MIT
#include <ctime>

#include <poll.h>

#include "hal/linux/can_bus.hpp"
#include "linux/shell.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using hal::CanFrame;
using hal::CanState;
using hal::on_linux::CanBus;
using hal::on_linux::CanError;
using std::chrono::milliseconds;

constexpr CanFrame frame{.id = 0x123, .length = 2, .data = {7, 8}};

class LinuxCanInterface : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
  void TearDown() override { restore_virtual_buses(); }
};

bool is_down(CanBus& bus) {
  (void)bus.receive();
  return bus.state() == CanState::down;
}

bool is_well(CanBus& bus) {
  (void)bus.receive();
  return bus.state() == CanState::error_active;
}

void expect_traffic(CanBus& bus) {
  CanBus other{"vcan0"};
  ASSERT_TRUE(bus.send(frame));
  EXPECT_EQ(next_frame(other), frame);
  ASSERT_TRUE(other.send(frame));
  EXPECT_EQ(next_frame(bus), frame);
}

TEST_F(LinuxCanInterface, TakenDownItIsDownAndRefusesFrames) {
  CanBus bus{"vcan0"};
  must("ip link set vcan0 down");
  EXPECT_TRUE(eventually([&] { return is_down(bus); }));
  EXPECT_FALSE(bus.send(frame));
  EXPECT_FALSE(bus.receive());
  EXPECT_EQ(bus.counters().sent, 0U);
  EXPECT_EQ(bus.counters().unsent, 1U);
}

TEST_F(LinuxCanInterface, SendingAloneFindsOutThatItIsDown) {
  CanBus bus{"vcan0"};
  must("ip link set vcan0 down");
  EXPECT_FALSE(bus.send(frame));
  EXPECT_EQ(bus.state(), CanState::down);
  EXPECT_EQ(bus.counters().unsent, 1U);
}

TEST_F(LinuxCanInterface, UpAgainItGoesOnByItself) {
  CanBus bus{"vcan0"};
  const int descriptor = bus.descriptor();
  for (int round = 0; round < 3; ++round) {
    must("ip link set vcan0 down");
    ASSERT_TRUE(eventually([&] { return is_down(bus); }));
    must("ip link set vcan0 up");
    ASSERT_TRUE(eventually([&] { return is_well(bus); }));
    expect_traffic(bus);
  }
  EXPECT_EQ(bus.descriptor(), descriptor);
}

TEST_F(LinuxCanInterface, RemovedAndMadeAgainItGoesOnByItself) {
  CanBus bus{"vcan0"};
  const int descriptor = bus.descriptor();
  for (int round = 0; round < 3; ++round) {
    must("ip link del vcan0");
    ASSERT_TRUE(eventually([&] { return is_down(bus); }));
    EXPECT_FALSE(bus.send(frame));
    must("ip link add vcan0 type vcan");
    (void)bus.receive();
    EXPECT_EQ(bus.state(), CanState::down) << "there, but not up yet";
    must("ip link set vcan0 up");
    ASSERT_TRUE(eventually([&] { return is_well(bus); }));
    expect_traffic(bus);
  }
  EXPECT_EQ(bus.descriptor(), descriptor);
}

TEST_F(LinuxCanInterface, RemovedAndMadeAgainBetweenTwoCallsItGoesOn) {
  CanBus bus{"vcan0"};
  must("ip link del vcan0 && ip link add vcan0 type vcan && ip link set vcan0 up");
  EXPECT_TRUE(eventually([&] { return bus.send(frame); }));
  EXPECT_TRUE(is_well(bus));
  expect_traffic(bus);
}

TEST_F(LinuxCanInterface, SendingAloneFindsTheInterfaceAgain) {
  CanBus bus{"vcan0"};
  must("ip link del vcan0");
  EXPECT_FALSE(bus.send(frame));
  must("ip link add vcan0 type vcan && ip link set vcan0 up");
  EXPECT_TRUE(eventually([&] { return bus.send(frame); }));
}

TEST_F(LinuxCanInterface, SomethingElseUnderTheNameIsNotTakenForTheBus) {
  CanBus bus{"vcan0"};
  must("ip link del vcan0 && ip link set lo down && ip link set lo name vcan0 && ip link set vcan0 up");
  (void)bus.receive();
  EXPECT_FALSE(eventually([&] { return !is_down(bus); }, milliseconds{300}));
  must("ip link set vcan0 down && ip link set vcan0 name lo && ip link set lo up");
}

TEST_F(LinuxCanInterface, FiltersSurviveTheChangeOfTheInterface) {
  const std::array filters{hal::on_linux::CanFilter{.id = 0x200, .mask = 0x7FF}};
  CanBus bus{"vcan0", filters};
  must("ip link del vcan0");
  ASSERT_TRUE(eventually([&] { return is_down(bus); }));
  must("ip link add vcan0 type vcan && ip link set vcan0 up");
  ASSERT_TRUE(eventually([&] { return is_well(bus); }));
  must("cansend vcan0 123#11");
  must("cansend vcan0 200#22");
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x200, .length = 1, .data = {0x22}}));
}

TEST_F(LinuxCanInterface, WaitsWithoutTurningTheProcessorWhileItIsDown) {
  CanBus bus{"vcan0"};
  must("ip link del vcan0");
  ASSERT_TRUE(eventually([&] { return is_down(bus); }));
  const std::clock_t before = std::clock();
  EXPECT_FALSE(bus.wait(milliseconds{500}));
  EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 5);
}

TEST_F(LinuxCanInterface, TheDescriptorBecomesReadableWithAFrame) {
  const CanBus bus{"vcan0"};
  pollfd listening{.fd = bus.descriptor(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&listening, 1, 0), 0);
  must("cansend vcan0 123#11");
  EXPECT_EQ(poll(&listening, 1, 5000), 1);
}

std::string trouble(const std::string& name) {
  try {
    const CanBus bus{name};
  } catch (const CanError& error) {
    return error.what();
  }
  return "none";
}

TEST_F(LinuxCanInterface, AWrongNameIsAnsweredWithWhatToDo) {
  EXPECT_EQ(
      trouble("can7"),
      "can7: no such interface; CAN interfaces here: vcan0, vcan1; with a 1 Mbit/s adapter: sudo ip link set can7 up "
      "type can bitrate 1000000; without hardware: with_vcan COMMAND (in tools/ of the sources, in libexec/fantail/ of "
      "an installation), or sudo ip link add vcan0 type vcan && sudo ip link set vcan0 up");
}

TEST_F(LinuxCanInterface, AnInterfaceThatIsNotCanIsRefused) {
  EXPECT_TRUE(trouble("lo").starts_with("lo: not a CAN interface; CAN interfaces here: vcan0, vcan1; "))
      << trouble("lo");
}

TEST_F(LinuxCanInterface, AnInterfaceThatIsDownIsRefusedWithTheCommandThatHelps) {
  must("ip link set vcan1 down");
  EXPECT_EQ(trouble("vcan1"), "vcan1: the interface is down; sudo ip link set vcan1 up");
}

TEST_F(LinuxCanInterface, ANameThatIsTooLongOrEmptyIsRefused) {
  EXPECT_TRUE(
      trouble("can_of_the_third_rocket").starts_with("\"can_of_the_third_rocket\": the name of an interface has 1"));
  EXPECT_TRUE(trouble("").starts_with("\"\": the name of an interface has 1"));
}

using hal::CanFrame;
using hal::on_linux::CanBus;
using hal::on_linux::CanFilter;

constexpr CanFrame last{.id = 0x7FF, .length = 1, .data = {0xEE}};

class LinuxCanFilter : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
};

/// What a bus hears of a mixture, up to the frame that everybody lets through.
std::vector<std::uint32_t> heard(CanBus& bus) {
  CanBus other{"vcan0"};
  for (const std::uint32_t id : {0x010U, 0x100U, 0x101U, 0x10FU, 0x120U}) {
    EXPECT_TRUE(other.send({.id = id, .length = 1}));
    EXPECT_TRUE(other.send({.id = id, .extended = true, .length = 1}));
  }
  EXPECT_TRUE(other.send(last));
  std::vector<std::uint32_t> ids;
  for (auto next = next_frame(bus); next && *next != last; next = next_frame(bus)) {
    ids.push_back(next->id | (next->extended ? 0x80000000U : 0U));
  }
  return ids;
}

TEST_F(LinuxCanFilter, WithoutOneAllElevenBitFramesPassAndNoOthers) {
  CanBus bus{"vcan0"};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x010, 0x100, 0x101, 0x10F, 0x120}));
}

TEST_F(LinuxCanFilter, OnlyWhatAgreesWithOneOfThemPasses) {
  const std::array filters{CanFilter{.id = 0x100, .mask = 0x7F0}, CanFilter{.id = 0x7FF, .mask = 0x7FF}};
  CanBus bus{"vcan0", filters};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x100, 0x101, 0x10F}));
}

TEST_F(LinuxCanFilter, ExtendedFramesPassWhenAskedFor) {
  const std::array filters{CanFilter{.id = 0x101, .mask = 0x1FFFFFFF, .extended = true},
                           CanFilter{.id = 0x7FF, .mask = 0x7FF}};
  CanBus bus{"vcan0", filters};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x80000101}));
}

}  // namespace

}  // namespace fantail::test
