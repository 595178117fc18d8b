// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "bench/exercise.hpp"
#include "link/avionics_link.hpp"
#include "link/session.hpp"

namespace fantail::bench {

/// The recording is too poor to judge the canards. what() tells a person so, with the known cause.
class Unmeasured : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Because this PC read late, or lost frames that had reached it.
class TooSlow : public Unmeasured {
  using Unmeasured::Unmeasured;
};

/// Advice after an exercise was given up after `done_s`: exercise one canard alone, if this PC kept up for as long as
/// that takes. Appended to what(); empty if it would not help.
[[nodiscard]] std::string advice(const Exercise& exercise, double done_s);

/// Goes through an exercise and records it, on the rocket's clock: time passes with the ticks that it reports.
/// `progress` is called with the seconds done; it may throw to give up. `seen` is called with every tick that is kept;
/// while it works, the rocket waits for a heartbeat. Throws Unmeasured as soon as too much is missing, and then
/// requests nothing more of the canards.
[[nodiscard]] link::Recording perform(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                                      const std::function<void(double)>& progress,
                                      const std::function<void(const link::Tick&)>& seen = {});

}  // namespace fantail::bench
