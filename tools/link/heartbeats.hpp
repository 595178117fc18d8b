// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "link/frame_order.hpp"

namespace fantail::link {

/// HeartbeatReport::uptime_ms, 24 bits: it begins again at 0 after 4 h 39 min 37.216 s.
using UptimeCounter = WrappingCounter<1 << 24>;

/// The clock of the avionics by its heartbeats, one in 100 ms of its own time; and whether one avionics alone can have
/// sent them, because a report does not say who did.
class Heartbeats {
 public:
  /// The next heartbeat, and how long ago at most the one before it came, where that is known. False: it does not go on
  /// from one before it, so it says nothing of the clock that is followed.
  bool hear(std::uint32_t uptime_ms, std::optional<std::int64_t> since_last_ms = std::nullopt);

  /// Of the clock that is followed: it does not wrap. A clock that has begun anew is followed from its second heartbeat
  /// on. Empty before the first heartbeat.
  [[nodiscard]] std::optional<std::int64_t> uptime_ms() const {
    return followed_ ? std::optional{followed_->total()} : std::nullopt;
  }

  /// A sentence about two clocks: between two heartbeats of one came another's, they come too often, or one is of a
  /// clock that went back and has run for longer since than there was time. Empty while there is one alone. It stays.
  [[nodiscard]] const std::optional<std::string>& two_rockets() const { return two_rockets_; }

 private:
  /// One that may be of one rocket.
  struct Clock {
    UptimeCounter uptime;
    std::int64_t last = 0;  ///< its newest heartbeat is this one of all
    [[nodiscard]] bool goes_on(std::uint32_t uptime_ms) const;
  };

  [[nodiscard]] Clock* clock_of(std::uint32_t uptime_ms);
  [[nodiscard]] bool is_too_soon(std::uint32_t uptime_ms);
  void found(std::int64_t one_ms, std::int64_t other_ms);

  std::vector<Clock> clocks_;  ///< heard lately; the newest is the last
  std::optional<UptimeCounter> followed_;
  std::optional<UptimeCounter> newest_;  ///< whose ever it is
  std::int64_t count_ = 0;
  int too_soon_ = 0;
  std::int64_t last_too_soon_ = 0;
  std::optional<std::string> two_rockets_;
};

}  // namespace fantail::link
