// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "listen/imu_log.hpp"

namespace fantail::listen {

/// Lift-off as somebody would read it off a plot, by a rule that knows nothing of the law: the first time at which the
/// axial specific force rises through 2 g and then stays above it for at least half of the next 0.3 s. In the log's
/// clock, between samples on a straight line; the first sample of a log that begins so. Readings at the end of a range
/// that ends below 2 g count as above it. Empty: never.
[[nodiscard]] std::optional<double> lift_off_s(const Signal& axial);

inline constexpr double lift_off_g = 2.0;
inline constexpr double lift_off_window_s = 0.3;

}  // namespace fantail::listen
