// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/time.hpp"

namespace fantail::sim {

inline constexpr core::Microseconds tick_time{1'000};

/// Things happen in the world at its ticks.
[[nodiscard]] inline core::Microseconds nearest_tick(double time_s) { return std::llround(time_s / 1e-3) * tick_time; }

[[nodiscard]] inline double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

}  // namespace fantail::sim
