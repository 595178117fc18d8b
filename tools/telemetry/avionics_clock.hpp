// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/clock.hpp"

namespace fantail::telemetry {

/// The avionics' clock, as far as its heartbeats let a listener know it: ten a second, in milliseconds, and a frame may
/// be held up on its way. Never goes backwards, except when the avionics has been switched on again.
class AvionicsClock {
 public:
  /// A heartbeat came. True: the avionics has been switched on again since the one before.
  bool hear(std::uint32_t uptime_ms, hal::Microseconds now);

  /// Empty before the first heartbeat.
  [[nodiscard]] std::optional<hal::Microseconds> at(hal::Microseconds now);

 private:
  std::optional<std::uint32_t> last_uptime_ms_;
  hal::Microseconds uptime_{};  ///< of the last heartbeat, over the wraps of its counter
  hal::Microseconds ahead_{};   ///< what the avionics' clock is before ours
  hal::Microseconds told_{};
};

}  // namespace fantail::telemetry
