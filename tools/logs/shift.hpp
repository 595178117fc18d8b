// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "logs/roll_log.hpp"

namespace fantail::logs {

struct ShiftSearch {
  std::size_t begin;  ///< of A's samples
  std::size_t end;
  double most_shift_s;
  double longest_gap_s;
};

struct FoundShift {
  double shift_s;
  bool at_the_edge;  ///< of the search: the best may lie beyond
};

/// The shift (of CompareOptions) with the smallest rms difference of the roll rates, much finer than the samples. Only
/// shifts count that leave at least half as many samples to compare as the best of them do: a short piece of calm
/// always agrees. Empty when nothing can be compared, or when all shifts agree equally well.
[[nodiscard]] std::optional<FoundShift> find_shift(const RollLog& a, const RollLog& b, const ShiftSearch& search);

}  // namespace fantail::logs
