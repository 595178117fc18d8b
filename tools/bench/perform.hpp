// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "bench/exercise.hpp"
#include "link/avionics_link.hpp"
#include "link/session.hpp"

namespace fantail::bench {

/// Goes through an exercise and records it, on the rocket's clock: time passes with the ticks that it reports.
/// `progress` is told the seconds done; it may throw to give up. `seen` is told every tick that is kept; while it works
/// the rocket waits for a heartbeat. Throws Unmeasured as soon as too much of it is missing, and then nothing is asked
/// of the canards any more.
[[nodiscard]] link::Recording perform(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                                      const std::function<void(double)>& progress,
                                      const std::function<void(const link::Tick&)>& seen = {});

}  // namespace fantail::bench
