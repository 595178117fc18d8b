// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>

#include "telemetry/receiver.hpp"

namespace fantail::telemetry {

// What both faces of the panel work out.

[[nodiscard]] inline std::optional<double> degrees(const std::optional<double>& radians) {
  return radians ? std::optional{*radians * 180.0 / std::numbers::pi} : std::nullopt;
}

[[nodiscard]] inline double in_seconds(hal::Microseconds time) { return static_cast<double>(time.count()) / 1e6; }

/// What has not come lately; what was missed before and came late does not make it less than none.
[[nodiscard]] inline std::int64_t lost_lately(const ChannelFigures& recent) {
  return std::max(recent.lost, std::int64_t{0});
}

}  // namespace fantail::telemetry
