// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "telemetry/messages.hpp"
#include "telemetry/outlet.hpp"
#include "telemetry/sender.hpp"

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

struct PublisherFigures {
  std::uint64_t published = 0;
  std::uint64_t dropped = 0;  ///< no room in the queue
  std::uint64_t failed = 0;   ///< not taken by the network or the disk
  bool complete = true;       ///< false: the disk has lost some of what it took
};

/// Publishes from a thread of its own, so that whoever flies never waits: not for a network, not for a disk.
class Publisher final : public Sink {
 public:
  /// All messages of five minutes of flight.
  static constexpr std::size_t queue_size = 65'536;

  explicit Publisher(std::unique_ptr<Outlet> outlet, std::size_t most_waiting = queue_size);
  /// What still waits is thrown away.
  ~Publisher() override;

  /// For one thread.
  void send(const Packet& packet) override;

  /// So far; for the thread that sends.
  [[nodiscard]] PublisherFigures figures() const;

  /// Waits until all that was sent has gone its way, and stops. To the network that takes a tenth of the flight's time.
  PublisherFigures finish();

 private:
  void work();
  void publish_batch(std::size_t most);

  std::unique_ptr<Outlet> outlet_;
  PacketQueue queue_;
  std::uint64_t dropped_ = 0;
  std::atomic<std::uint64_t> published_ = 0;
  std::atomic<std::uint64_t> failed_ = 0;
  bool complete_ = true;
  std::atomic<bool> finish_ = false;
  std::atomic<bool> give_up_ = false;
  std::thread thread_;
};

}  // namespace fantail::telemetry
