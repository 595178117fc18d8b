// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "paper/claim.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

/// Section 4.3.2's search for the number of disturbance intervals N1: over the constant offset of the simulated flight,
/// and over one that varies. `window` is the first window of the flight `run`.
[[nodiscard]] std::vector<Claim> offset_intervals(const identify::model::Record& window, const Run& run);

}  // namespace fantail::paper
