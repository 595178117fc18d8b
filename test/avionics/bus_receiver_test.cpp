// SPDX-License-Identifier: MIT
#include "avionics/bus_receiver.hpp"

#include <gtest/gtest.h>

#include "avionics/board_rig.hpp"

namespace fantail::avionics {
namespace {

using protocol::Rejection;

hal::CanFrame heartbeat(std::uint8_t counter) {
  return can_frame(encode(protocol::BenchSession{.action = protocol::SessionAction::keep, .session = 7}, counter));
}

class Receiver : public testing::Test {
 protected:
  int messages_of_a_tick() {
    int messages = 0;
    receiver.begin_tick();
    while (receiver.next(now, board, session)) {
      messages += 1;
    }
    return messages;
  }
  int rejected(Rejection cause) { return receiver.rejections().count[static_cast<std::size_t>(cause)]; }

  hal::sim::CanWire wire;
  hal::sim::CanBus board{wire};
  hal::sim::CanBus pc{wire};
  BusReceiver receiver;
  core::Microseconds now{};
  std::optional<std::uint16_t> session = 7;
};

TEST_F(Receiver, AnExtendedFrameWithTheIdentifierOfABenchIsUnknown) {
  hal::CanFrame frame = heartbeat(0);
  frame.extended = true;
  (void)pc.send(frame);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::unknown_id), 1);
}

TEST_F(Receiver, ARemoteFrameHasNoBytesWhateverLengthItAsksFor) {
  hal::CanFrame frame = heartbeat(0);
  frame.remote = true;
  (void)pc.send(frame);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_length), 1);
}

TEST_F(Receiver, GoodFramesTooHaveAShareOfTheTickAndTheRestComesInTheNext) {
  for (int i = 0; i < 30; ++i) {
    (void)pc.send(heartbeat(static_cast<std::uint8_t>(i % 16)));
  }
  EXPECT_EQ(messages_of_a_tick(), BusReceiver::most_frames_per_tick);
  EXPECT_EQ(messages_of_a_tick(), 30 - BusReceiver::most_frames_per_tick);
}

TEST_F(Receiver, AFrameOutsideOfSessionsIsRefusedOnlyWhenTheSameHasJustCome) {
  const auto begin = [](std::uint8_t counter) {
    return can_frame(encode(protocol::ArmRequest{.action = protocol::ArmAction::begin}, counter));
  };
  for (const auto counter : std::to_array<std::uint8_t>({3, 9, 2, 3})) {  // as two benches count
    (void)pc.send(begin(counter));
    EXPECT_EQ(messages_of_a_tick(), 1) << int{counter};
  }
  (void)pc.send(begin(3));
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_counter), 1);
  now += core::Microseconds{100'001};
  (void)pc.send(begin(3));
  EXPECT_EQ(messages_of_a_tick(), 1);
}

TEST_F(Receiver, ARequestWithoutASessionIsStaleAndForAnotherOneItHasAWrongChecksum) {
  const auto request = can_frame(encode(protocol::BenchRequest{}, 0, 7));
  session.reset();
  (void)pc.send(request);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::stale), 1);
  session = 8;
  (void)pc.send(request);
  EXPECT_EQ(messages_of_a_tick(), 0);
  EXPECT_EQ(rejected(Rejection::wrong_crc), 1);
}

}  // namespace
}  // namespace fantail::avionics
