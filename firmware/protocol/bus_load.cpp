// SPDX-License-Identifier: MIT
#include "protocol/bus_load.hpp"

#include <algorithm>
#include <cstddef>

namespace fantail::protocol {
namespace {

using core::Microseconds;

/// Takes the bits of a frame in the order of the wire; counts stuff bits and computes the frame's own CRC-15.
class Wire {
 public:
  void put(std::uint32_t value, int bits) {
    for (int i = bits - 1; i >= 0; --i) {
      put_bit(((value >> static_cast<unsigned>(i)) & 1U) != 0U);
    }
  }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }
  [[nodiscard]] std::uint32_t bits() const { return bits_; }

 private:
  void put_bit(bool bit) {
    const bool feeds_back = bit != ((crc_ & 0x4000U) != 0U);
    crc_ = (crc_ << 1U) & 0x7FFFU;
    if (feeds_back) {
      crc_ ^= 0x4599U;
    }
    run_ = bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    ++bits_;
    if (run_ == 5) {  // a bit of the other kind follows, and is the first of the next run
      last_ = !bit;
      run_ = 1;
      ++bits_;
    }
  }

  std::uint32_t crc_ = 0;
  std::uint32_t bits_ = 0;
  int run_ = 0;
  bool last_ = true;
};

Microseconds time_of(const PeriodicFrame& frame) { return frame.bits * bus_bit_time; }

/// How often a frame can become ready in a time.
std::int64_t arrivals(const PeriodicFrame& frame, Microseconds within) {
  return (within + *frame.period - Microseconds{1}) / *frame.period;
}

constexpr Microseconds no_bound = std::chrono::minutes{1};

/// The least time, from `start` on, that is as long as `fixed` and every frame that counts and becomes ready in it (or
/// up to `margin` later) take together.
template <typename Counts>
Microseconds settle(std::span<const PeriodicFrame> frames, Microseconds fixed, Microseconds start, Microseconds margin,
                    Counts counts) {
  Microseconds time = start;
  while (time < no_bound) {
    Microseconds sum = fixed;
    for (const PeriodicFrame& other : frames) {
      if (counts(other)) {
        sum += arrivals(other, time + margin) * time_of(other);
      }
    }
    if (sum == time) {
      break;
    }
    time = sum;
  }
  return time;
}

}  // namespace

std::uint32_t bits_on_wire(const BusFrame& frame) {
  const std::size_t length = std::min<std::size_t>(frame.length, frame.data.size());
  Wire wire;
  wire.put(0, 1);  // start of frame
  wire.put(frame.id, 11);
  wire.put(0, 3);  // data frame, 11-bit identifier, reserved
  wire.put(static_cast<std::uint32_t>(length), 4);
  for (std::size_t i = 0; i < length; ++i) {
    wire.put(frame.data[i], 8);
  }
  wire.put(wire.crc(), 15);
  return wire.bits() + bits_after_the_crc;
}

float bus_load(std::span<const PeriodicFrame> frames) {
  float load = 0.0F;
  for (const PeriodicFrame& frame : frames) {
    if (frame.period) {
      load += static_cast<float>(time_of(frame).count()) / static_cast<float>(frame.period->count());
    }
  }
  return load;
}

std::optional<Microseconds> worst_latency(std::span<const PeriodicFrame> frames, std::uint16_t id) {
  const auto own = std::ranges::find(frames, id, &PeriodicFrame::id);
  if (own == frames.end()) {
    return std::nullopt;
  }
  if (std::ranges::any_of(frames, [id](const PeriodicFrame& frame) { return frame.id <= id && !frame.period; })) {
    return std::nullopt;
  }
  Microseconds blocking{};
  for (const PeriodicFrame& other : frames) {
    if (other.id > id) {
      blocking = std::max(blocking, time_of(other));
    }
  }
  const auto more_urgent = [id](const PeriodicFrame& other) { return other.id < id; };
  const auto as_urgent = [id](const PeriodicFrame& other) { return other.id <= id; };

  // For as long as the bus is busy with frames of this urgency, an earlier frame of the same kind can delay the next.
  const Microseconds busy = settle(frames, blocking, time_of(*own), Microseconds{}, as_urgent);
  if (busy >= no_bound) {
    return std::nullopt;
  }
  Microseconds worst{};
  for (std::int64_t earlier = 0; earlier < arrivals(*own, busy); ++earlier) {
    const Microseconds fixed = blocking + earlier * time_of(*own);
    // A frame that becomes ready in the very bit in which the bus falls idle still takes part.
    const Microseconds starts = settle(frames, fixed, fixed, bus_bit_time, more_urgent);
    worst = std::max(worst, starts - earlier * *own->period + time_of(*own));
  }
  return worst;
}

}  // namespace fantail::protocol
