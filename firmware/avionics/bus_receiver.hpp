// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "hal/can_bus.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

/// Takes frames off the bus and lets through only what is whole, in order and within its range. Whatever is refused is
/// counted by its cause, and nothing else happens.
class BusReceiver {
 public:
  /// More than a bus of 1 Mbit/s can deliver in a millisecond: a babbling node cannot make a tick long.
  static constexpr int most_frames_per_tick = 24;

  /// The next message; empty when none waits or this tick has had its share. `session`: the one that is open now.
  std::optional<protocol::FromBench> next(core::Microseconds now, hal::CanBus& bus,
                                          std::optional<std::uint16_t> session);

  void begin_tick() { frames_ = 0; }

  /// For a message that was let through and then found to be nobody's.
  void count(protocol::Rejection rejection);

  /// Modulo 256.
  [[nodiscard]] const protocol::RejectionReport& rejections() const { return rejections_; }

 private:
  /// Long enough for a frame that the bus has doubled, too short for a person.
  static constexpr core::Microseconds memory{100'000};

  struct Received {
    protocol::BusFrame frame{};
    core::Microseconds time{};
  };

  /// The counters of the open session, which begin with it and which no other bench's frames touch.
  struct SessionCounters {
    std::optional<std::uint16_t> session{};
    protocol::Sequence heartbeats{};
    protocol::Sequence requests{};
  };

  [[nodiscard]] bool follows_on(core::Microseconds now, const protocol::BusFrame& frame,
                                const protocol::FromBench& message, std::uint8_t counter);
  [[nodiscard]] bool is_repeated(core::Microseconds now, const protocol::BusFrame& frame, std::size_t kind);

  SessionCounters counters_{};
  std::array<std::optional<Received>, std::variant_size_v<protocol::FromBench>> last_{};  ///< outside of sessions
  protocol::RejectionReport rejections_{};
  int frames_ = 0;
};

}  // namespace fantail::avionics
