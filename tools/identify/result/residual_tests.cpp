// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/result/residual.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using Bins = std::vector<std::optional<double>>;

constexpr std::size_t farthest = 20;  // bins

// Means over bins: what a gyro's filter spreads over a few milliseconds is noise, not memory. A bin that lies in a gap
// is empty.
Bins binned(const Record& record, const std::vector<double>& values, double width_s) {
  Bins bins(static_cast<std::size_t>(std::lround(record.time_s.back() / width_s)) + 1);
  std::vector<double> count(bins.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<std::size_t>(std::lround(record.time_s[i] / width_s));
    bins[at] = bins[at].value_or(0.0) + values[i];
    count[at] += 1.0;
  }
  double sum = 0.0;
  double filled = 0.0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    if (bins[k]) {
      *bins[k] /= count[k];
      sum += *bins[k];
      filled += 1.0;
    }
  }
  for (auto& bin : bins) {
    if (bin) {
      *bin -= sum / filled;
    }
  }
  return bins;
}

// Of `later` with `earlier`, so many bins apart.
double correlation(const Bins& earlier, const Bins& later, std::size_t apart) {
  double together = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t k = 0; k + apart < later.size(); ++k) {
    const auto& a = earlier[k];
    const auto& b = later[k + apart];
    if (a && b) {
      together += *a * *b;
      first += *a * *a;
      second += *b * *b;
    }
  }
  const double size = std::sqrt(first * second);
  return size > 0.0 ? together / size : 0.0;
}

double strongest(const Bins& earlier, const Bins& later, std::size_t nearest) {
  double most = 0.0;
  for (std::size_t apart = nearest; apart <= farthest && apart < later.size(); ++apart) {
    const double here = correlation(earlier, later, apart);
    most = std::abs(here) > std::abs(most) ? here : most;
  }
  return most;
}

// By how much two signals that remember themselves correlate farther by chance than white ones (Bartlett 1935).
double widened(const Bins& one, const Bins& other) {
  double sum = 1.0;
  for (std::size_t apart = 1; apart <= farthest && apart < one.size(); ++apart) {
    sum += 2.0 * correlation(one, one, apart) * correlation(other, other, apart);
  }
  return std::sqrt(std::max(1.0, sum));
}

}  // namespace

ResidualTests test_residual(const Record& record, const Simulation& simulation) {
  constexpr double bin_s = 0.01;
  // Of Gauss' distribution: 1 in 100 that the strongest of 20 lies beyond, on either side.
  constexpr double one_of_twenty = 3.48;
  const double step_s = record.time_s.back() / static_cast<double>(record.size() - 1);
  const double width_s = std::max(bin_s, step_s);
  std::vector<double> residual = record.roll_rate_rad_s;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] -= simulation.roll_rate_rad_s[i];
  }
  const Bins rest = binned(record, residual, width_s);
  const Bins canards = binned(record, simulation.canard_rad, width_s);
  const auto filled = std::ranges::count_if(rest, [](const auto& bin) { return bin.has_value(); });
  const double chance = one_of_twenty / std::sqrt(static_cast<double>(filled));
  return {.own_correlation = strongest(rest, rest, 2),
          .canard_correlation = strongest(canards, rest, 0),
          .chance = std::min(1.0, chance),
          .canard_chance = std::min(1.0, chance * widened(rest, canards))};
}

}  // namespace fantail::identify::result
