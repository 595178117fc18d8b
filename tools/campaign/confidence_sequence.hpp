// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::campaign {

/// Where a share lies.
struct Bounds {
  double low = 0.0;
  double high = 1.0;
};

/// Bounds of a share of which `count` of `of` independent runs had it, that hold all along: with 95 % probability the
/// true share is within them after every run, however often somebody looks and decides to go on. (An interval for one
/// number of runs misses far more often when one stops as soon as it is narrow.) Robbins' mixture of likelihood ratios
/// with an even prior, by Ville's inequality; wider than Wilson's interval. Nothing is known of no runs: 0 to 1.
[[nodiscard]] Bounds confidence_sequence(std::uint64_t count, std::uint64_t of);

}  // namespace fantail::campaign
