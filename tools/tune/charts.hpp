// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "result/document.hpp"
#include "tune/tuning.hpp"

namespace fantail::tune {

// Pictures of tune.html, each of both plans; of a tuning that has found a law.

/// Least phase margin and crossover over air speed.
[[nodiscard]] std::vector<result::Block> loop_pictures(const Tuning& tuning);
/// Roll angle and command over time, as the vehicle as it is was flown.
[[nodiscard]] std::vector<result::Block> step_pictures(const Tuning& tuning);

}  // namespace fantail::tune
