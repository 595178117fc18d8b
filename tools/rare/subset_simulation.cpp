// SPDX-License-Identifier: MIT
#include "rare/subset_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "distributions/quantiles.hpp"
#include "distributions/shares.hpp"
#include "runs/runner.hpp"
#include "sim/random.hpp"

namespace fantail::rare {
namespace {

constexpr std::uint64_t plain_stream = 3'999;
constexpr std::uint64_t first_stream = 4'000;  // one a level; those of a campaign and of the world are others
constexpr int most_draws = 1'000;              // of a point that the laws exclude
constexpr double best_acceptance = 0.44;
constexpr double first_step = 0.8;
constexpr double smallest_step = 0.02;
constexpr double largest_factor = 10.0;  // where one number alone decides, those that begin are close together
constexpr std::size_t groups = 5;        // of chains: each begins with the step that the ones before it found

std::uint64_t seed_from(sim::Random& random) { return random.bits() >> 11U; }  // 53 bits, as of every flight

sim::Random random_of(const Settings& settings, std::size_t level, std::size_t chain) {
  return {runs::key_of_run(settings.master_seed, chain), first_stream + level};
}

Point point_from(sim::Random& random, std::size_t dimensions) {
  Point point{.normals = std::vector<double>(dimensions)};
  std::ranges::generate(point.normals, [&] { return random.gaussian(); });
  point.seed = seed_from(random);
  return point;
}

Chain plain_sample(const Settings& settings, const Margin& margin, std::size_t number) {
  sim::Random random = random_of(settings, 0, number);
  for (int draws = 0; draws < most_draws; ++draws) {
    Sample sample{.point = point_from(random, settings.dimensions)};
    if (const auto found = margin(sample.point)) {
      sample.margin = *found;
      return {.samples = {std::move(sample)}};
    }
  }
  return {};  // nearly all of the law is outside
}

/// What a level's chains have in common.
struct Moves {
  double threshold;
  std::vector<double> steps;  ///< s of each normal number
};

Chain walk(const Settings& settings, const Margin& margin, std::size_t level, std::size_t number, Sample begin,
           std::size_t length, const Moves& moves) {
  sim::Random random = random_of(settings, level, number);
  Chain chain{.samples = {std::move(begin)}};
  while (chain.samples.size() < length) {
    const Sample& now = chain.samples.back();
    Sample next{.point = now.point};
    for (std::size_t i = 0; i < next.point.normals.size(); ++i) {
      const double step = moves.steps[i];
      next.point.normals[i] = std::sqrt(1.0 - step * step) * now.point.normals[i] + step * random.gaussian();
    }
    // Another seed is another noise: where it decides, few such moves are accepted, and the others still go on.
    if (const std::uint64_t seed = seed_from(random); random.bits() >> 63U == 1) {
      next.point.seed = seed;
    }
    chain.moves += 1;
    const auto found = margin(next.point);
    const bool is_accepted = found && *found <= moves.threshold;
    chain.accepted += is_accepted ? 1 : 0;
    next.margin = found.value_or(0.0);
    chain.samples.push_back(is_accepted ? std::move(next) : Sample{now});
  }
  return chain;
}

/// How far each number spreads among those that begin, times one factor for all. In two places at once it spreads
/// farther than its law, and a step from one to the other is never accepted.
std::vector<double> steps_from(const std::vector<Sample>& begin, double factor) {
  std::vector<double> steps(begin.front().point.normals.size());
  const auto count = static_cast<double>(begin.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const Sample& sample : begin) {
      sum += sample.point.normals[i];
      squares += sample.point.normals[i] * sample.point.normals[i];
    }
    const double variance = std::max(0.0, squares / count - sum * sum / (count * count));
    steps[i] = std::min(1.0, factor * std::sqrt(variance));
  }
  return steps;
}

/// Of the share of the samples at or below a margin: its coefficient of variation, with the correlation that the
/// samples of one chain have at each distance from each other.
double variation_of(const std::vector<Chain>& chains, double at_most, std::size_t samples, double share) {
  const auto is_in = [at_most](const Sample& sample) { return sample.margin <= at_most ? 1.0 : 0.0; };
  std::size_t longest = 0;
  for (const Chain& chain : chains) {
    longest = std::max(longest, chain.samples.size());
  }
  const double variance = share * (1.0 - share);
  double factor = 1.0;
  for (std::size_t apart = 1; apart < longest && variance > 0.0; ++apart) {
    double sum = 0.0;
    double pairs = 0.0;
    for (const Chain& chain : chains) {
      for (std::size_t i = 0; i + apart < chain.samples.size(); ++i) {
        sum += is_in(chain.samples[i]) * is_in(chain.samples[i + apart]);
        pairs += 1.0;
      }
    }
    const double covariance = pairs > 0.0 ? sum / pairs - share * share : 0.0;
    factor += 2.0 * pairs / static_cast<double>(samples) * covariance / variance;
  }
  return std::sqrt((1.0 - share) / (share * static_cast<double>(samples)) * std::max(factor, 1.0));
}

std::vector<Sample> all_of(const std::vector<Chain>& chains) {
  std::vector<Sample> all;
  for (const Chain& chain : chains) {
    all.insert(all.end(), chain.samples.begin(), chain.samples.end());
  }
  std::ranges::stable_sort(all, {}, &Sample::margin);
  return all;
}

/// Of the samples of one level between its own threshold and the next, at a hundred of them.
void add_to_curve(Estimate& found, const std::vector<Sample>& all, std::size_t from) {
  const std::size_t step = std::max<std::size_t>(1, (all.size() - from) / 100);
  for (std::size_t i = all.size(); i > from; i -= std::min(step, i)) {
    if (std::isfinite(all[i - 1].margin)) {
      found.curve.emplace_back(all[i - 1].margin,
                               found.probability * static_cast<double>(i) / static_cast<double>(all.size()));
    }
  }
}

std::uint64_t sum_of(const std::vector<Chain>& chains, std::uint64_t Chain::* count) {
  return std::transform_reduce(chains.begin(), chains.end(), std::uint64_t{0}, std::plus{}, std::mem_fn(count));
}

std::optional<double> accepted_of(const std::vector<Chain>& chains) {
  const auto moves = static_cast<double>(sum_of(chains, &Chain::moves));
  return moves == 0.0 ? std::nullopt : std::optional{static_cast<double>(sum_of(chains, &Chain::accepted)) / moves};
}

/// So many samples in so many chains: the first few are one longer where it does not divide.
std::size_t length_of(std::size_t chain, std::size_t chains, std::size_t samples) {
  return samples / chains + (chain < samples % chains ? 1 : 0);
}

void conclude(Estimate& found) {
  double squares = 0.0;
  for (const Level& level : found.levels) {
    squares += level.coefficient_of_variation * level.coefficient_of_variation;
  }
  found.coefficient_of_variation = std::sqrt(squares);
  if (found.end != End::found) {
    return;
  }
  if (found.levels.size() == 1) {
    const Level& only = found.levels.front();
    const auto bounds = distributions::wilson(
        static_cast<std::uint64_t>(std::llround(only.share * static_cast<double>(only.samples))), only.samples);
    found.low = bounds.low;
    found.high = bounds.high;
    return;
  }
  // The logarithm of a product of many shares is nearly normal, the product is not.
  const double reach = std::exp(distributions::normal_975 * std::sqrt(std::log1p(squares)));
  found.low = found.probability / reach;
  found.high = std::min(1.0, found.probability * reach);
}

}  // namespace

Point plain_point(const Settings& settings, std::size_t number) {
  sim::Random random{runs::key_of_run(settings.master_seed, number), plain_stream};
  return point_from(random, settings.dimensions);
}

Estimate estimate(const Settings& settings, const Margin& margin, const MakeAll& make_all) {
  Estimate found{.probability = 1.0};
  double factor = first_step;
  std::vector<Chain> chains =
      make_all(0, settings.samples_a_level, [&](std::size_t number) { return plain_sample(settings, margin, number); });
  for (std::size_t level = 0;; ++level) {
    const std::vector<Sample> all = all_of(chains);
    const std::size_t count = all.size();
    const auto failing =
        static_cast<std::size_t>(std::ranges::lower_bound(all, 0.0, {}, &Sample::margin) - all.begin());
    const auto kept = static_cast<std::size_t>(share_kept * static_cast<double>(count));
    const std::optional<double> accepted = accepted_of(chains);
    found.points += level == 0 ? count : sum_of(chains, &Chain::moves);
    if (level == 0) {
      std::ranges::transform(all, std::back_inserter(found.plain_margins), &Sample::margin);
    }
    const auto note = [&](double threshold, std::size_t below) {
      const double share = static_cast<double>(below) / static_cast<double>(count);
      found.levels.push_back({.samples = count,
                              .threshold = threshold,
                              .share = share,
                              .coefficient_of_variation = variation_of(chains, threshold, count, share),
                              .accepted = accepted});
      found.probability *= share;
    };
    found.failing = {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(failing)};
    found.nearest = all.front();
    const bool is_last = level + 1 == settings.most_levels;
    if (failing >= kept || (is_last && failing > 0)) {
      add_to_curve(found, all, 0);
      note(0.0, failing);
      found.end = level == 0 && failing == count ? End::always_fails : End::found;
      break;
    }
    const double threshold = all[kept - 1].margin;
    const auto below =
        static_cast<std::size_t>(std::ranges::upper_bound(all, threshold, {}, &Sample::margin) - all.begin());
    if (2 * below > count) {
      found.end = End::does_not_advance;
      found.stuck_at = threshold;
      break;
    }
    add_to_curve(found, all, below);
    note(threshold, below);
    if (is_last) {
      found.end = End::never_fails;
      break;
    }
    const std::vector<Sample> begin{all.begin(), all.begin() + static_cast<std::ptrdiff_t>(below)};
    chains.clear();
    for (std::size_t group = 0; group < groups; ++group) {
      // Every fifth of those that begin, which stand in the order of their margins.
      const std::size_t count_of_group = (below + groups - 1 - group) / groups;
      const Moves moves{.threshold = threshold, .steps = steps_from(begin, factor)};
      std::vector<Chain> own = make_all(groups * level + group + 1, count_of_group, [&](std::size_t number) {
        const std::size_t chain = groups * number + group;
        return walk(settings, margin, level + 1, chain, begin[chain], length_of(chain, below, settings.samples_a_level),
                    moves);
      });
      if (const auto accepted_of_group = accepted_of(own)) {
        factor = std::clamp(factor * std::exp(*accepted_of_group - best_acceptance), smallest_step, largest_factor);
      }
      std::ranges::move(own, std::back_inserter(chains));
    }
  }
  conclude(found);
  return found;
}

}  // namespace fantail::rare
