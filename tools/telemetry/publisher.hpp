// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "telemetry/messages.hpp"
#include "telemetry/sender.hpp"
#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Where packets leave the program. May wait: it is called by the publisher's own thread.
class Outlet {
 public:
  virtual ~Outlet() = default;
  /// False: this one is lost.
  virtual bool put(const Packet& packet) = 0;
  /// After the last one. False: some of what was put did not arrive after all (a full disk).
  virtual bool close() = 0;
  /// As many a second as receivers can be expected to take; empty: any number.
  [[nodiscard]] virtual std::optional<int> most_per_second() const = 0;
};

/// The network, or a log file for lcm-logplayer whose clock is that of the avionics. An LCM log of that name
/// is overwritten, no other file. Throws TelemetryError.
[[nodiscard]] std::unique_ptr<Outlet> open_outlet(const Url& url);

/// An LCM log in memory, for what is to be written as a whole or not at all. Its clock is that of the avionics.
class MemoryLog final : public Sink {
 public:
  MemoryLog();
  ~MemoryLog() override;
  MemoryLog(const MemoryLog&) = delete;
  MemoryLog& operator=(const MemoryLog&) = delete;

  void send(const Packet& packet) override;

  /// All that was sent, as the content of a file; to be called once, at the end.
  [[nodiscard]] std::string take();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

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
  std::uint64_t failed = 0;   ///< not accepted by the network or the disk
  bool complete = true;       ///< false: the disk has lost some of what it took
};

/// Publishes from a thread of its own, so that the flight never waits for a network or a disk.
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
