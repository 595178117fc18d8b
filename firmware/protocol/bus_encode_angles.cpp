// SPDX-License-Identifier: MIT
// Apart from the other frames, because two of these go out in every tick of a flight: this file is compiled for speed.
#include "protocol/bus_angle_frame.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_frames.hpp"

namespace fantail::protocol {

BusFrame encode(const BenchRequest& message, std::uint8_t counter, std::uint16_t session) {
  return angle_frame(BenchRequestFrame::id, message.angle, counter, session);
}

BusFrame encode(const CommandReport& message, std::uint8_t counter) {
  return angle_frame(CommandReportFrame::id, message.angle, counter);
}

BusFrame encode(const EncoderReport& message, std::uint8_t counter) {
  return angle_frame(EncoderReportFrame::id, message.angle, counter);
}

}  // namespace fantail::protocol
