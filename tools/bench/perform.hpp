// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "bench/exercise.hpp"
#include "link/avionics_link.hpp"
#include "link/session.hpp"

namespace fantail::bench {

/// What was recorded says nothing of the canards. what() says it for a person, and what is known of the cause.
class Unmeasured : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Because this PC read late, or lost frames that had reached it.
class TooSlow : public Unmeasured {
  using Unmeasured::Unmeasured;
};

/// What else may be done when an exercise was given up after so long: one canard alone, where this PC kept up for as
/// long as that takes. Goes on behind what(); empty where it would not help.
[[nodiscard]] std::string advice(const Exercise& exercise, double done_s);

/// Goes through an exercise and records it, on the rocket's clock: time passes with the ticks that it reports.
/// `progress` is told the seconds done; it may throw to give up. `seen` is told every tick that is kept; while it works
/// the rocket waits for a heartbeat. Throws Unmeasured as soon as too much of it is missing, and then nothing is asked
/// of the canards any more.
[[nodiscard]] link::Recording perform(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                                      const std::function<void(double)>& progress,
                                      const std::function<void(const link::Tick&)>& seen = {});

}  // namespace fantail::bench
