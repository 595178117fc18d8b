// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "flip_trial.hpp"

namespace fantail::board {

/// A moment of the flight in which bits flip.
struct Moment {
  const char* name;
  core::Phase phase;
  double after_s;  ///< that it began
  int weight;      ///< how many of the flips, of the sum of all weights
};

/// How many of each outcome, by region and by phase; what the pins did; and each that must not be, with its number.
[[nodiscard]] std::string table_of(std::span<const Trial> trials, std::span<const Moment> moments);

/// A whole pulse was beyond the plan's limit, or beyond the hard one.
[[nodiscard]] bool is_beyond(const Trial& trial);

}  // namespace fantail::board
