// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "listen/imu_log.hpp"

namespace fantail::listen {

/// Lift-off as somebody would read it off a plot, by a rule that is independent of the law: the first time at which the
/// axial specific force rises through 2 g, then stays above it for at least half of the next 0.3 s, and begins a push
/// that makes a flight of it. The push lasts until the force has been below 1.5 g for 0.1 s; it makes a flight when
/// what it has above 1 g comes to 20 m/s, when it stands at the end of the accelerometer's range for 0.5 s in all, or
/// when the log ends in it. A hand gives less (docs/devices.md).
///
/// In the log's clock, between samples on a straight line; the first sample of a log that begins so. Readings at the
/// end of a range that ends below 2 g count as above it. Behind the first come those of further pushes: of another
/// launch, another stage, the shock of a parachute, the landing. Empty: never.
[[nodiscard]] std::vector<double> lift_offs_s(const Signal& axial);

inline constexpr double lift_off_g = 2.0;
inline constexpr double lift_off_window_s = 0.3;
inline constexpr double push_end_g = 1.5;
inline constexpr double push_pause_s = 0.1;
inline constexpr double flight_impulse_m_s = 20.0;
inline constexpr double flight_clipped_s = 0.5;

}  // namespace fantail::listen
