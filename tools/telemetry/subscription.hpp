// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Hears our channels on an LCM network, or in a log at the log's own pace.
class Subscription {
 public:
  /// Takes one message: its channel and its bytes.
  using Take = std::function<void(std::string_view channel, std::span<const std::byte> bytes)>;

  /// Throws TelemetryError.
  explicit Subscription(const Url& url);
  ~Subscription();
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  /// Until something has come, at most so long; a signal ends it early.
  void wait(std::chrono::milliseconds at_most) const;

  /// Hands over all that has come. False: the log has ended.
  bool listen(const Take& take);

  /// Of a log, so far: bytes that belong to no whole event.
  [[nodiscard]] std::uint64_t foreign_bytes() const;

 private:
  class Network;
  class Log;
  std::unique_ptr<Network> network_;  ///< one of the two
  std::unique_ptr<Log> log_;
};

}  // namespace fantail::telemetry
