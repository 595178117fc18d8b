// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace fantail::core {

/// Time since the clock of the board (or the world) started. Instants are subtracted as integers; only a difference
/// becomes a float, because a float of a time of day has lost the microseconds.
using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

/// A difference of two instants as seconds; exact to 1 us below 16 s.
[[nodiscard]] constexpr float seconds(Microseconds difference) {
  return static_cast<float>(difference.count()) * 1e-6F;
}

/// The nearest whole microsecond to a plan's time. Valid for 0 <= value_s <= 3600 s.
[[nodiscard]] constexpr Microseconds from_seconds(float value_s) {
  return Microseconds{static_cast<std::int64_t>(value_s * 1e6F + 0.5F)};
}

}  // namespace fantail::core
