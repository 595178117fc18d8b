// SPDX-License-Identifier: MIT
#include "avionics/bus_receiver.hpp"

#include <limits>
#include <utility>

#include "avionics/can_frame.hpp"

namespace fantail::avionics {
namespace {

using protocol::Rejection;

protocol::Decoded<protocol::FromBench> decode(const hal::CanFrame& frame, std::optional<std::uint16_t> session) {
  if (frame.extended || frame.id > std::numeric_limits<std::uint16_t>::max()) {
    return {.rejection = Rejection::unknown_id};
  }
  if (frame.remote) {
    return {.rejection = Rejection::wrong_length};
  }
  return protocol::decode_from_bench(bus_frame(frame), session);
}

}  // namespace

std::optional<protocol::FromBench> BusReceiver::next(core::Microseconds now, hal::CanBus& bus,
                                                     std::optional<std::uint16_t> session) {
  if (counters_.session != session) {
    // Meets BEN-6.
    counters_ = {.session = session};
  }
  // Meets BUS-2, BUS-3.
  for (; frames_ < most_frames_per_tick; ++frames_) {
    const std::optional<hal::CanFrame> frame = bus.receive();
    if (!frame) {
      return std::nullopt;
    }
    const auto decoded = decode(*frame, session);
    if (!decoded.message) {
      count(decoded.rejection);
    } else if (decoded.counter && !follows_on(now, bus_frame(*frame), *decoded.message, *decoded.counter)) {
      count(Rejection::wrong_counter);
    } else {
      frames_ += 1;
      return decoded.message;
    }
  }
  return std::nullopt;
}

bool BusReceiver::follows_on(core::Microseconds now, const protocol::BusFrame& frame,
                             const protocol::FromBench& message, std::uint8_t counter) {
  if (std::holds_alternative<protocol::BenchRequest>(message)) {
    return counters_.requests.lost_before(counter) == 0;
  }
  if (const auto* heartbeat = std::get_if<protocol::BenchSession>(&message)) {
    return heartbeat->session != counters_.session || counters_.heartbeats.lost_before(counter) == 0;
  }
  // Nobody knows which bench said this, so a counter that jumps may be another one's, and says nothing.
  return !is_repeated(now, frame, message.index());
}

bool BusReceiver::is_repeated(core::Microseconds now, const protocol::BusFrame& frame, std::size_t kind) {
  const auto before = std::exchange(last_[kind], Received{.frame = frame, .time = now});
  return before && before->frame == frame && now - before->time <= memory;
}

void BusReceiver::count(Rejection rejection) { rejections_.count[static_cast<std::size_t>(rejection)] += 1; }

}  // namespace fantail::avionics
