// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "page/svg_plot.hpp"

namespace fantail::page {

std::vector<std::size_t> keep_extremes(std::span<const std::vector<double>> series, std::size_t buckets) {
  const std::size_t count = series.empty() ? 0 : series.front().size();
  std::vector<std::size_t> kept;
  if (count <= 3 * buckets) {
    kept.resize(count);
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    const std::size_t begin = bucket * count / buckets;
    const std::size_t end = (bucket + 1) * count / buckets;
    kept.push_back(begin);
    for (const std::vector<double>& values : series) {
      std::size_t smallest = begin;
      std::size_t largest = begin;
      for (std::size_t i = begin; i < end; ++i) {
        // Written so that a NaN at the start gives way to the first number.
        if (!(values[i] >= values[smallest]) && values[i] == values[i]) {
          smallest = i;
        }
        if (!(values[i] <= values[largest]) && values[i] == values[i]) {
          largest = i;
        }
      }
      kept.push_back(smallest);
      kept.push_back(largest);
    }
  }
  kept.push_back(count - 1);
  std::ranges::sort(kept);
  const auto repeats = std::ranges::unique(kept);
  kept.erase(repeats.begin(), repeats.end());
  return kept;
}

std::vector<std::size_t> gaps(std::span<const double> x) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < x.size(); ++i) {
    steps.push_back(x[i] - x[i - 1]);
  }
  std::vector<std::size_t> found;
  if (steps.empty()) {
    return found;
  }
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > 5.0 * *middle) {
      found.push_back(i + 1);
    }
  }
  return found;
}

}  // namespace fantail::page
