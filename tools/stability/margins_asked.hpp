// SPDX-License-Identifier: MIT
#pragma once

#include "sim/units.hpp"

namespace fantail::stability {

// The phase margins that all verbs ask of a roll loop: new and plan check, tune and predict.

/// With the numbers that a vehicle states: what control engineers call comfortable. `plan check` warns of less.
inline constexpr double comfortable_phase_margin_rad = 45.0 * sim::radians_per_degree;
/// Wherever in their ranges those numbers may truly be: of 95 % of the runs of a go.
inline constexpr double least_phase_margin_deg = 30.0;
inline constexpr double least_phase_margin_rad = least_phase_margin_deg * sim::radians_per_degree;

}  // namespace fantail::stability
