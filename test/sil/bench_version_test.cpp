// SPDX-License-Identifier: MIT
// Heartbeats of other versions of the bus protocol, as a bench hears them.
#include <gtest/gtest.h>

#include "avionics/can_frame.hpp"
#include "protocol/bus_codec.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

/// On the bus of a rocket, and what sends heartbeats of version 35 there.
class OtherVersion : public testing::Test {
 protected:
  void send_heartbeat(std::uint32_t uptime_ms) {
    (void)other.send(avionics::can_frame(encode(protocol::HeartbeatReport{.version = 35, .uptime_ms = uptime_ms})));
  }

  BenchAtWorld place{"bench_healthy"};
  hal::sim::CanBus other{place.wire};
  link::AvionicsLink link{place.bus()};
};

TEST_F(OtherVersion, OneFrameOfAnotherDeviceDoesNotMakeTheAvionicsOneOfAnotherVersion) {
  send_heartbeat(0);
  EXPECT_NO_THROW(link::await_avionics(place, link));
}

TEST_F(OtherVersion, AnAvionicsThatSaysNothingElseIsRefusedByItsVersion) {
  place.switch_off();
  place.after_tick = [this, uptime_ms = std::uint32_t{0}]() mutable {
    if (++uptime_ms % 100 == 0) {
      send_heartbeat(uptime_ms);
    }
  };
  try {
    link::await_avionics(place, link);
    FAIL() << "it was taken for one of ours";
  } catch (const link::LinkError& error) {
    EXPECT_STREQ(error.what(), "the avionics uses version 35 of the bus protocol; this program uses version 2");
  }
}

}  // namespace
}  // namespace fantail::sil
