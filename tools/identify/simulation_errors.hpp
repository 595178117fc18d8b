// SPDX-License-Identifier: MIT
#pragma once

#include "identify/estimate.hpp"
#include "identify/record.hpp"

namespace fantail::identify {

/// Fills in how far the simulated angle and rate are from the measured ones.
void add_errors(Simulation& simulation, const Record& record);

}  // namespace fantail::identify
