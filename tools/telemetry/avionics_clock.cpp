// SPDX-License-Identifier: MIT
#include "telemetry/avionics_clock.hpp"

#include <algorithm>

namespace fantail::telemetry {
namespace {

constexpr std::uint32_t wrap_ms = 1U << 24U;

}  // namespace

bool AvionicsClock::hear(std::uint32_t uptime_ms, hal::Microseconds now) {
  // Less than half a wrap on is on; anything else is back, and a clock goes back only by a new start.
  const std::uint32_t step_ms = last_uptime_ms_ ? (uptime_ms - *last_uptime_ms_) % wrap_ms : 0;
  const bool new_start = step_ms >= wrap_ms / 2;
  if (!last_uptime_ms_ || new_start) {
    uptime_ = std::chrono::milliseconds{uptime_ms};
    ahead_ = uptime_ - now;
    told_ = {};
  } else {
    uptime_ += std::chrono::milliseconds{step_ms};
    const hal::Microseconds heard = uptime_ - now;
    // A frame can come late but not early. The slow way back follows two clocks that do not go alike.
    ahead_ = heard > ahead_ ? heard : ahead_ + (heard - ahead_) / 8;
  }
  last_uptime_ms_ = uptime_ms;
  return new_start;
}

std::optional<hal::Microseconds> AvionicsClock::at(hal::Microseconds now) {
  if (!last_uptime_ms_) {
    return std::nullopt;
  }
  told_ = std::max(told_, now + ahead_);
  return told_;
}

}  // namespace fantail::telemetry
