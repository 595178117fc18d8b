// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "telemetry/receiver.hpp"

namespace fantail::telemetry {

// What the text and the JSON of the panel both need.

[[nodiscard]] inline std::optional<double> degrees(const std::optional<double>& radians) {
  return radians ? std::optional{*radians * 180.0 / std::numbers::pi} : std::nullopt;
}

[[nodiscard]] inline double in_seconds(hal::Microseconds time) { return static_cast<double>(time.count()) / 1e6; }

/// "launched -> controlling (guide_clear)", "canard 3: healthy -> stalled".
[[nodiscard]] inline std::string event_text(const Event& event) {
  if (event.phase) {
    return fmt::format("{} -> {} ({})", core::name(event.phase->before), core::name(event.phase->phase),
                       core::name(event.phase->reason));
  }
  return fmt::format("canard {}: {} -> {}", event.verdict->canard + 1, core::name(event.verdict->before),
                     core::name(event.verdict->verdict));
}

/// What has not come lately; what was missed before and came late does not make it less than none.
[[nodiscard]] inline std::int64_t lost_lately(const ChannelFigures& recent) {
  return std::max(recent.lost, std::int64_t{0});
}

}  // namespace fantail::telemetry
