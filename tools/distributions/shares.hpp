// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// What is known of a share of which `count` of `of` independent tries had it. Of no tries nothing is known: 0 to 1.
namespace fantail::distributions {

struct Bounds {
  double low = 0.0;
  double high = 1.0;
};

/// Wilson's 95 % interval (1927) for a number of tries that was fixed beforehand; sensible also where all or none had
/// it.
[[nodiscard]] Bounds wilson(std::uint64_t count, std::uint64_t of);

/// Bounds that hold all along: with 95 % probability the true share is within them after every try, however often
/// somebody looks and decides to go on. (An interval for one number of tries misses far more often when one stops as
/// soon as it is narrow.) Robbins' mixture of likelihood ratios with an even prior, by Ville's inequality; wider than
/// Wilson's interval.
[[nodiscard]] Bounds confidence_sequence(std::uint64_t count, std::uint64_t of);

/// The largest share that the count leaves possible with 95 % (Clopper and Pearson, one-sided): with it so few would
/// come in one of twenty campaigns. 1 also when all had it.
[[nodiscard]] double upper_bound_95(std::uint64_t count, std::uint64_t of);

}  // namespace fantail::distributions
