// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "runs/row_text.hpp"

namespace fantail::rare {

/// What is not known of one flight: independent standard normal numbers, and the seed of all else that is random.
struct Point {
  std::vector<double> normals{};
  std::uint64_t seed = 0;
};

/// A point that was looked at.
struct Sample {
  Point point{};
  double margin = 0.0;  ///< how far it is from failing: below zero it fails
};
inline void fields(runs::RowText& text, Sample& sample) {
  text(sample.point.normals, sample.point.seed, sample.margin);
}

/// Samples that were made one from the other. The first is where they begin.
struct Chain {
  std::vector<Sample> samples{};
  std::uint64_t moves = 0;     ///< that were tried
  std::uint64_t accepted = 0;  ///< of them
};
inline void fields(runs::RowText& text, Chain& chain) { text(chain.samples, chain.moves, chain.accepted); }

/// Subset simulation (Au and Beck, Probabilistic Engineering Mechanics 16, 2001) with the conditional sampling of
/// Papaioannou et al. (same journal, 41, 2015): the probability of a rare event as a product of larger ones. The first
/// level are plain samples; each further one has samples whose margin is below that of a tenth of the level before,
/// made by Markov chains that begin at that tenth. A move draws every normal number anew as
/// z' = sqrt(1 - s^2) z + s xi, and, every second time, another seed.
struct Settings {
  std::uint64_t master_seed = 1;
  std::size_t dimensions = 1;
  std::size_t samples_a_level = 3'000;  ///< 100 or more
  std::size_t most_levels = 12;         ///< the smallest probability looked for is a tenth to this power
};
inline constexpr double share_kept = 0.1;

/// The margin of a point, never exactly zero; infinite where nothing leads from it to a failure; empty for one that the
/// laws of its numbers exclude. From any thread. One margin is another flight: what it costs is counted by whoever
/// flies.
using Margin = std::function<std::optional<double>(const Point& point)>;

/// Makes `chains` items by calling `make` for each number below, in any order and on any thread: each depends on
/// nothing but its number. `batch` is another one at every call, in their order. A chain that `make`
/// returns without samples (a thousand points in a row were excluded) it may not return: it throws.
using MakeAll = std::function<std::vector<Chain>(std::size_t batch, std::size_t chains,
                                                 const std::function<Chain(std::size_t)>& make)>;

struct Level {
  std::size_t samples = 0;
  double threshold = 0.0;               ///< the share below has at most this margin; of the last level 0
  double share = 0.0;                   ///< of its samples
  double coefficient_of_variation = 0;  ///< of the share, with the correlation of the chains
  std::optional<double> accepted{};     ///< share of the moves; empty: plain samples
};

enum class End : std::uint8_t {
  found,        ///< as many samples of the last level fail as it takes
  never_fails,  ///< no level came so far: the probability is below a tenth to the power of most_levels
  always_fails,
  does_not_advance,  ///< most samples of a level have the same margin, which tells no way to go
};

struct Estimate {
  End end = End::found;
  double probability = 0.0;  ///< of `found`; for the others what the levels came to
  double coefficient_of_variation = 0.0;
  double low = 0.0;  ///< 95 % interval
  double high = 1.0;
  std::vector<Level> levels{};
  std::vector<Sample> failing{};        ///< of the last level, the most negative margin first
  std::optional<Sample> nearest{};      ///< of the last level that with the smallest margin
  double stuck_at = 0.0;                ///< of does_not_advance: the margin that most samples have
  std::vector<double> plain_margins{};  ///< of the first level
  std::uint64_t points = 0;             ///< that were looked at
  /// How probable a margin of at most so much is, the largest margin first.
  std::vector<std::pair<double, double>> curve{};
};

/// The plain sample of this number: another than those of estimate(), which come from other streams.
[[nodiscard]] Point plain_point(const Settings& settings, std::size_t number);

[[nodiscard]] Estimate estimate(const Settings& settings, const Margin& margin, const MakeAll& make_all);

}  // namespace fantail::rare
