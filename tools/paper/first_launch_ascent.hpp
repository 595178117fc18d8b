// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "paper/claim.hpp"
#include "paper/runs.hpp"
#include "report/results.hpp"

namespace fantail::paper {

/// Height, speed and times of the first launch beside those of its simulated flight.
[[nodiscard]] std::vector<Claim> first_launch_ascent(const Run& run, const report::Figures& figures);

}  // namespace fantail::paper
