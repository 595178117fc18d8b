// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Takes our messages from an LCM network as they come, in a thread of its own: the kernel keeps a few hundred packets,
/// and a listener is busy for longer now and then.
class DatagramReceiver {
 public:
  /// Keeps so many messages; what comes then is thrown away.
  static constexpr std::size_t most_waiting = 10'000;

  /// Throws TelemetryError.
  explicit DatagramReceiver(const Url& url);
  ~DatagramReceiver();
  DatagramReceiver(const DatagramReceiver&) = delete;
  DatagramReceiver& operator=(const DatagramReceiver&) = delete;

  /// Until something has come, at most so long; a signal ends it early.
  void wait(std::chrono::milliseconds at_most) const;

  /// Hands over all that has come.
  void hand_over(const std::function<void(std::string_view channel, std::span<const std::byte> bytes)>& take);

 private:
  struct Message {
    std::string channel;
    std::vector<std::byte> bytes;
  };
  /// A descriptor that is closed with its owner.
  struct Descriptor {
    explicit Descriptor(int which) : number{which} {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number;
  };

  void open(const Url& url) const;
  void receive();
  void keep(std::span<const std::byte> datagram);

  Descriptor socket_;
  Descriptor end_;   ///< readable when the thread shall end
  Descriptor news_;  ///< readable while messages wait
  std::mutex mutex_;
  std::vector<Message> messages_;
  std::thread thread_;
};

}  // namespace fantail::telemetry
