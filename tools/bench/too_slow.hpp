// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "bench/exercise.hpp"

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

}  // namespace fantail::bench
