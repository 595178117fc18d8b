// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "bench/exercise.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

/// Smaller steps from the trim show nothing: a canard that stands where its tolerances allow, and does not move at all,
/// would have reached the angle.
[[nodiscard]] double least_step_rad(const sim::CanardTolerances& tolerances);
/// Smaller amplitudes show nothing: most of the way of a canard that is just quick enough could be missing. Infinite
/// where it goes less far than that at any amplitude.
[[nodiscard]] double least_amplitude_rad(double frequency_hz, const sim::CanardTolerances& tolerances);

/// Throws std::invalid_argument, for a person, when a step or a sine, within the limit, is smaller.
void expect_enough_movement(const Exercise& exercise, std::size_t canard, const sim::CanardTolerances& tolerances);

}  // namespace fantail::bench
