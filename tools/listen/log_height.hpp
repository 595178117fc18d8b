// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "listen/imu_log.hpp"

namespace fantail::listen {

/// What the log's own height (a barometer's, mostly) says of the flight.
struct LogHeight {
  Signal above_pad{};  ///< m above its mean over the last second before lift-off, or above its first figure
  std::optional<double> apogee_s{};  ///< log's clock
  double apogee_m = 0.0;
};

/// Apogee is where a running median over 0.5 s is largest, after lift-off: the charge of a parachute and the passage of
/// Mach 1 put spikes into a barometer. Empty apogee: no lift-off, no height there, or one that ends while it still
/// rises.
[[nodiscard]] LogHeight log_height(const Signal& height, std::optional<double> lift_off_s);

}  // namespace fantail::listen
