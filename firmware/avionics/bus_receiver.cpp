// SPDX-License-Identifier: MIT
#include "avionics/bus_receiver.hpp"

#include <limits>

#include "avionics/can_frame.hpp"

namespace fantail::avionics {
namespace {

using protocol::Rejection;

protocol::Decoded<protocol::FromBench> decode(const hal::CanFrame& frame) {
  if (frame.extended || frame.id > std::numeric_limits<std::uint16_t>::max()) {
    return {.rejection = Rejection::unknown_id};
  }
  if (frame.remote) {
    return {.rejection = Rejection::wrong_length};
  }
  return protocol::decode_from_bench(bus_frame(frame));
}

}  // namespace

std::optional<protocol::FromBench> BusReceiver::next(core::Microseconds now, hal::CanBus& bus) {
  for (; frames_ < most_frames_per_tick; ++frames_) {
    const std::optional<hal::CanFrame> frame = bus.receive();
    if (!frame) {
      return std::nullopt;
    }
    const auto decoded = decode(*frame);
    if (!decoded.message) {
      count(decoded.rejection);
    } else if (decoded.counter && !follows_on(now, decoded.message->index(), *decoded.counter)) {
      count(Rejection::wrong_counter);
    } else {
      frames_ += 1;
      return decoded.message;
    }
  }
  return std::nullopt;
}

bool BusReceiver::follows_on(core::Microseconds now, std::size_t kind, std::uint8_t counter) {
  Kind& known = kinds_[kind];
  if (now - known.last > memory) {
    known.sequence.forget();
  }
  known.last = now;
  return known.sequence.lost_before(counter) == 0;
}

void BusReceiver::count(Rejection rejection) { rejections_.count[static_cast<std::size_t>(rejection)] += 1; }

}  // namespace fantail::avionics
