// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::paper {

/// What slows a rocket that coasts straight up.
struct Coasting {
  double drag_per_mass_1_m = 0.0;  ///< 1/2 rho CdA / m: the deceleration is this times the speed squared, plus gravity
};

/// The least time in which any motor can bring a rocket `height_m` up and to rest there without it ever being faster
/// than `top_speed_m_s`: top speed from the first instant, held by thrust, then a coast. The thrust is never negative,
/// so nothing stops sooner than a coast: no ascent with at most this drag takes less.
[[nodiscard]] double least_time_to_apogee_s(double height_m, double top_speed_m_s, const Coasting& coasting);

}  // namespace fantail::paper
