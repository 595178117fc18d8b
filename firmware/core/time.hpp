// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace fantail::core {

/// Time since the clock of the board (or the world) started. Instants are subtracted as integers; only a difference
/// becomes a float, because a float of a time of day has lost the microseconds.
using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

/// A difference of two instants as seconds; good to 1 us below 16 s.
[[nodiscard]] constexpr float seconds(Microseconds difference) {
  return static_cast<float>(difference.count()) * 1e-6F;
}

/// A time in whole microseconds, off by at most 0.55 us; valid for 0 <= value_s <= 3600 s. Whole seconds are split off
/// first, because the product of the two would already have lost the microsecond. Mind that above 8 s the float itself no longer
/// names every microsecond: whoever reads times from text converts them without a float.
[[nodiscard]] constexpr Microseconds from_seconds(float value_s) {
  const auto whole_s = static_cast<std::int64_t>(value_s);
  const float rest_s = value_s - static_cast<float>(whole_s);
  return Microseconds{whole_s * 1'000'000 + static_cast<std::int64_t>(rest_s * 1e6F + 0.5F)};
}

}  // namespace fantail::core
