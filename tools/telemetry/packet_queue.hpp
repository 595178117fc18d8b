// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "telemetry/packet.hpp"

namespace fantail::telemetry {

/// From one thread to one other, without locks: neither ever waits for the other.
class PacketQueue {
 public:
  explicit PacketQueue(std::size_t capacity) : places_(capacity + 1) {}

  /// False: full.
  bool push(const Packet& packet) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    const std::size_t next = (end + 1) % places_.size();
    if (next == begin_.load(std::memory_order_acquire)) {
      return false;
    }
    places_[end] = packet;
    end_.store(next, std::memory_order_release);
    return true;
  }

  /// The oldest one, until pop(); null: empty.
  [[nodiscard]] const Packet* front() const {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    return begin == end_.load(std::memory_order_acquire) ? nullptr : &places_[begin];
  }
  void pop() { begin_.store((begin_.load(std::memory_order_relaxed) + 1) % places_.size(), std::memory_order_release); }

 private:
  std::vector<Packet> places_;
  std::atomic<std::size_t> begin_ = 0;
  std::atomic<std::size_t> end_ = 0;
};

}  // namespace fantail::telemetry
