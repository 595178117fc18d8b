// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/airframe.hpp"

namespace fantail::stability {

/// Over the air speed: a stable rocket swings in pitch at this many radians a second for each m/s. From lift-off to
/// after burn-out, the smaller one first.
struct PitchFrequency {
  double least_1_m = 0.0;
  double most_1_m = 0.0;
};

/// Empty where the rocket does not swing back, at lift-off or after burn-out.
[[nodiscard]] std::optional<PitchFrequency> pitch_frequency(const sim::Airframe& airframe, double density_kg_m3);

/// How far from the pitch frequency, as a share of it, a roll rate still counts as near resonance. With the damping
/// ratio of 0.14 of a usual rocket the angle of attack is about twice as large there, and 3.6 times as large at the
/// resonance.
inline constexpr double near_resonance = 0.25;

}  // namespace fantail::stability
