// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "bench/exercise.hpp"
#include "link/avionics_link.hpp"
#include "link/session.hpp"

namespace fantail::bench {

/// Goes through an exercise and records it, on the rocket's clock: time passes with the ticks that it reports.
/// `progress` is told the seconds done; it may throw to give up. Throws TooSlow as soon as this PC has been too slow
/// for a measurement.
[[nodiscard]] link::Recording perform(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                                      const std::function<void(double)>& progress);

}  // namespace fantail::bench
