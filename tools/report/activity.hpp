// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "flight/flight.hpp"

namespace fantail::report {

/// Canards that go on swinging although nothing excites them and the reference stands still: a loop that oscillates.
struct Oscillation {
  double from_s = 0.0;  ///< where it was first seen
  double frequency_hz = 0.0;
  double lowest_rad = 0.0;  ///< canard angle, in the second with the widest swing
  double highest_rad = 0.0;
};

/// Looks at the true canards, a second at a time: three or more swings of a degree to either side, that do not die
/// away. Where no truth is known, at the encoders' mean, and the command must swing as far; where that is unknown, too,
/// at the command alone. Left out are the excitation and what settles after control start, after a step of the
/// reference and after the excitation, for `settling_time_s` each.
[[nodiscard]] std::optional<Oscillation> find_oscillation(std::span<const flight::Row> control, double settling_time_s);

}  // namespace fantail::report
