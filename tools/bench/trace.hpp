// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bench/exercise.hpp"
#include "link/avionics_link.hpp"

namespace fantail::bench {

inline constexpr double tick_s = 0.001;
/// Of all ticks of an exercise, what may be missing: single ones hide nothing, more make the figures doubtful.
inline constexpr double most_lost_share = 0.02;
/// A mark is set when a tick is received, and the command that belongs to it may already be there; or it comes late,
/// when bench or node were held up.
inline constexpr std::size_t mark_slack = 100;  // ticks
inline constexpr double no_reading = std::numeric_limits<double>::quiet_NaN();

/// One canard through one turn, one entry a millisecond: lost ticks have their place too, so an index is a time.
struct CanardTrace {
  std::int64_t first_tick = 0;
  std::vector<double> command_rad;  ///< where it is not known, the last one known
  std::vector<double> encoder_rad;  ///< no_reading where there was none
  std::vector<Part> part;
  std::vector<bool> limited;
  std::size_t received = 0;  ///< ticks
  std::size_t dropouts = 0;  ///< of these, without a valid reading
  std::size_t undriven = 0;  ///< of these, with the servo's output off

  [[nodiscard]] std::size_t size() const { return command_rad.size(); }
};

/// Empty when the turn was not recorded, or the canard never driven in it.
[[nodiscard]] CanardTrace trace_of(const link::Recording& recording, const Exercise& exercise, const Turn& turn,
                                   std::size_t canard);

/// Indices [begin, end) of a trace.
struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Where in this part the command had stood still long enough for the canard to stand too; empty when nowhere.
[[nodiscard]] Window at_rest(const CanardTrace& trace, Part part);

/// Index of the first tick with the new command of a step, in this part or shortly before it; size() when there is
/// none.
[[nodiscard]] std::size_t step_begin(const CanardTrace& trace, Part part);

/// From `begin` to where the command changes next.
[[nodiscard]] Window while_command_stands(const CanardTrace& trace, std::size_t begin);

}  // namespace fantail::bench
