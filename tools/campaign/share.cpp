// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "campaign/analysis.hpp"
#include "distributions/shares.hpp"

namespace fantail::campaign {
namespace {

double point(const std::vector<double>& sorted, double share_below) {
  const double place = share_below * static_cast<double>(sorted.size() - 1);
  const auto before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, sorted.size() - 1);
  return sorted[before] + (place - static_cast<double>(before)) * (sorted[after] - sorted[before]);
}

}  // namespace

Share share(std::size_t count, std::size_t of) {
  const auto [low, high] = distributions::wilson(count, of);
  return of == 0 ? Share{}
                 : Share{.count = count,
                         .of = of,
                         .value = static_cast<double>(count) / static_cast<double>(of),
                         .low = low,
                         .high = high};
}

Quantiles quantiles(std::vector<double> values) {
  std::ranges::sort(values);
  return {.mean = std::reduce(values.begin(), values.end()) / static_cast<double>(values.size()),
          .p5 = point(values, 0.05),
          .p50 = point(values, 0.5),
          .p95 = point(values, 0.95)};
}

std::vector<Quantiles> quantiles_over(std::span<const std::span<const double>> tracks, double least_share) {
  std::vector<Quantiles> all;
  for (;;) {
    std::vector<double> values;
    for (const std::span<const double> track : tracks) {
      if (all.size() < track.size()) {
        values.push_back(track[all.size()]);
      }
    }
    if (values.empty() || static_cast<double>(values.size()) < least_share * static_cast<double>(tracks.size())) {
      return all;
    }
    all.push_back(quantiles(std::move(values)));
  }
}

}  // namespace fantail::campaign
