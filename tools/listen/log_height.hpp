// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "listen/imu_log.hpp"

namespace fantail::listen {

/// So soon after lift-off a height has to say something, or it is none of that flight.
constexpr double height_within_s = 5.0;

/// What the log's own height (a barometer's, mostly) says of the flight.
struct LogHeight {
  Signal above_pad{};  ///< m above its mean over the last second before lift-off, or above its first figure
  std::optional<double> apogee_s{};  ///< log's clock
  double apogee_m = 0.0;
};

/// Apogee is where a running median over 0.5 s is largest, after lift-off: the charge of a parachute and the passage of
/// Mach 1 put spikes into a barometer. Empty apogee: no lift-off, no height in the first five seconds after it, or one
/// that ends while it still rises. `until_s`: where another flight begins.
[[nodiscard]] LogHeight log_height(const Signal& height, std::optional<double> lift_off_s,
                                   std::optional<double> until_s = {});

}  // namespace fantail::listen
