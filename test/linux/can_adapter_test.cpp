// SPDX-License-Identifier: MIT
// Real error frames of the kernel: the slcan driver makes them of what an adapter reports.

#include "hal/linux/can_bus.hpp"
#include "linux/adapter.hpp"
#include "linux/shell.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using hal::CanFrame;
using hal::CanState;
using hal::on_linux::CanBus;

bool reaches(CanBus& bus, CanState state) {
  return eventually([&] {
    (void)bus.receive();
    return bus.state() == state;
  });
}

CanFrame numbered(unsigned number) {
  return {.id = 0x100,
          .length = 8,
          .data = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U), 1, 2, 3, 4, 5, 6}};
}

std::string as_lawicel(unsigned number) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string text = "t1008";
  for (const unsigned byte : {number & 0xFFU, number >> 8U & 0xFFU, 1U, 2U, 3U, 4U, 5U, 6U}) {
    text += digits[byte >> 4U];
    text += digits[byte & 0xFU];
  }
  return text;
}

TEST(LinuxCanAdapter, CarriesFramesBothWays) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  ASSERT_TRUE(bus.send(numbered(0x1234)));
  EXPECT_TRUE(eventually([&] { return adapter.taken() == std::vector<std::string>{as_lawicel(0x1234)}; }));
  adapter.say({"t1232AABB"});
  EXPECT_EQ(next_frame(bus), (CanFrame{.id = 0x123, .length = 2, .data = {0xAA, 0xBB}}));
}

TEST(LinuxCanAdapter, WarningPassiveAndActiveAgainAreSeen) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  EXPECT_EQ(bus.state(), CanState::error_active);
  adapter.say({"sw096100"});
  EXPECT_TRUE(reaches(bus, CanState::error_warning));
  EXPECT_EQ(bus.counters().errors, 1U);
  adapter.say({"sp130200"});
  EXPECT_TRUE(reaches(bus, CanState::error_passive));
  EXPECT_EQ(bus.counters().errors, 2U);
  EXPECT_TRUE(bus.send(numbered(1))) << "a passive node still talks";
  adapter.say({"sa000000"});
  EXPECT_TRUE(reaches(bus, CanState::error_active));
}

TEST(LinuxCanAdapter, AFrameWithoutAcknowledgementIsCountedAndChangesNoState) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  adapter.say({"e1a"});
  EXPECT_TRUE(eventually([&] {
    (void)bus.receive();
    return bus.counters().errors == 1;
  }));
  EXPECT_EQ(bus.state(), CanState::error_active);
}

TEST(LinuxCanAdapter, BusOffIsSeenAndNothingIsAcceptedUntilTheInterfaceIsUpAgain) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  adapter.say({"sw096100", "e1a", "sp130200", "sb256256"});
  ASSERT_TRUE(reaches(bus, CanState::bus_off));
  EXPECT_GE(bus.counters().errors, 4U);
  EXPECT_FALSE(bus.send(numbered(1)));
  EXPECT_EQ(bus.counters().unsent, 1U);
  must("ip link set " + adapter.interface() + " down");
  EXPECT_TRUE(reaches(bus, CanState::down));
  must("ip link set " + adapter.interface() + " up");
  EXPECT_TRUE(reaches(bus, CanState::error_active));
  ASSERT_TRUE(bus.send(numbered(2)));
  EXPECT_TRUE(eventually([&] { return adapter.taken() == std::vector<std::string>{as_lawicel(2)}; }));
}

TEST(LinuxCanAdapter, AnAdapterThatStopsReadingFillsABoundedQueueThatDrainsInOrder) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  adapter.stop_reading();
  std::vector<std::string> accepted;
  unsigned number = 0;
  // The kernel's own buffers come first; they are bounded too.
  while (bus.send(numbered(number))) {
    accepted.push_back(as_lawicel(number));
    ++number;
    ASSERT_LT(number, 20'000U);
  }
  EXPECT_EQ(accepted.size() - bus.counters().sent, CanBus::queue_size);
  EXPECT_EQ(bus.counters().unsent, 1U);
  EXPECT_FALSE(bus.send(numbered(number)));
  EXPECT_EQ(bus.counters().unsent, 2U);
  EXPECT_EQ(bus.state(), CanState::error_active);

  adapter.go_on_reading();
  EXPECT_TRUE(eventually([&] {
    (void)bus.receive();
    return adapter.taken().size() >= accepted.size();
  }));
  EXPECT_EQ(adapter.taken(), accepted);
  EXPECT_EQ(bus.counters().sent, accepted.size());
}

TEST(LinuxCanAdapter, WaitingAloneDrainsTheQueue) {
  Adapter adapter;
  CanBus bus{adapter.interface()};
  adapter.stop_reading();
  while (bus.send(numbered(7))) {
  }
  const auto waiting = bus.counters().sent + CanBus::queue_size;
  adapter.go_on_reading();
  EXPECT_FALSE(bus.wait(std::chrono::seconds{2}));
  EXPECT_EQ(bus.counters().sent, waiting);
}

TEST(LinuxCanAdapter, UnpluggedIsDownAndWhatWaitedIsCountedAsUnsent) {
  std::optional<Adapter> adapter{std::in_place};
  CanBus bus{adapter->interface()};
  adapter->stop_reading();
  while (bus.send(numbered(7))) {
  }
  const auto refused = bus.counters().unsent;
  must("ip link set " + adapter->interface() + " down");
  adapter.reset();
  EXPECT_TRUE(reaches(bus, CanState::down));
  EXPECT_EQ(bus.counters().unsent, refused + CanBus::queue_size);
}

}  // namespace
}  // namespace fantail::test
