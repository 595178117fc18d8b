// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "paper/claim.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

/// Section 4.3.2's search for the number of disturbance intervals N1: over the constant offset of the simulated flight,
/// and over one that varies. `window` is the first window of the flight `run`.
[[nodiscard]] std::vector<Claim> offset_intervals(const identify::model::Record& window, const Run& run);

/// "0.21 deg, 0.66 deg/s": what so many intervals leave of angle and rate over the one that varies.
[[nodiscard]] std::string errors_over_a_wave(const identify::model::Record& window, const Run& run,
                                             std::size_t intervals);

}  // namespace fantail::paper
