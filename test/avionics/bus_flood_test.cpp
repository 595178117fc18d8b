// SPDX-License-Identifier: MIT
// More frames than a tick has time for.
#include <gtest/gtest.h>

#include "avionics/bus_receiver.hpp"
#include "avionics/can_frame.hpp"
#include "hal/sim/can_bus.hpp"

namespace fantail::avionics {
namespace {

hal::CanFrame nobodys() { return {.id = 0x7FF}; }
hal::CanFrame begin(std::uint8_t counter) {
  return can_frame(encode(protocol::ArmRequest{.action = protocol::ArmAction::begin}, counter));
}

/// Frames that have arrived and have not been read.
int left_on(hal::sim::CanBus& board) {
  int left = 0;
  while (board.receive()) {
    left += 1;
  }
  return left;
}

TEST(BusFlood, ATickReads24FramesAndNotOneMoreWhateverTheyAre) {
  for (const int every : {1, 2, 1000}) {  // each is good, every other one, none
    hal::sim::CanWire wire;
    hal::sim::CanBus board{wire};
    hal::sim::CanBus node{wire};
    BusReceiver receiver;
    for (int i = 0; i < 60; ++i) {
      (void)node.send((i + 1) % every == 0 ? begin(static_cast<std::uint8_t>(i % 16)) : nobodys());
    }
    int messages = 0;
    receiver.begin_tick();
    for (int again = 0; again < 100; ++again) {
      messages += receiver.next({}, board, std::nullopt) ? 1 : 0;
    }
    EXPECT_EQ(messages, 24 / every);
    EXPECT_EQ(receiver.rejections().count[static_cast<std::size_t>(protocol::Rejection::unknown_id)], 24 - messages);
    EXPECT_EQ(left_on(board), 60 - 24);
  }
}

}  // namespace
}  // namespace fantail::avionics
