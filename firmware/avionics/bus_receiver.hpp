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

  /// The next message; empty when none waits or this tick has had its share.
  std::optional<protocol::FromBench> next(core::Microseconds now, hal::CanBus& bus);

  void begin_tick() { frames_ = 0; }

  /// For a message that was let through and then found to be nobody's.
  void count(protocol::Rejection rejection);

  /// Modulo 256.
  [[nodiscard]] const protocol::RejectionReport& rejections() const { return rejections_; }

 private:
  /// A bench that begins anew does not know how far the one before it had counted. Long enough for a lost frame or two,
  /// too short for a person.
  static constexpr core::Microseconds memory{100'000};

  struct Kind {
    protocol::Sequence sequence;
    core::Microseconds last{};
  };

  [[nodiscard]] bool follows_on(core::Microseconds now, std::size_t kind, std::uint8_t counter);

  std::array<Kind, std::variant_size_v<protocol::FromBench>> kinds_{};
  protocol::RejectionReport rejections_{};
  int frames_ = 0;
};

}  // namespace fantail::avionics
