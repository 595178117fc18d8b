// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include "campaign/analysis.hpp"
#include "distributions/quantiles.hpp"

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
  if (of == 0) {
    return {};
  }
  constexpr double z = distributions::normal_975;
  const auto n = static_cast<double>(of);
  const double p = static_cast<double>(count) / n;
  const double scale = 1.0 / (1.0 + z * z / n);
  const double centre = scale * (p + 0.5 * z * z / n);
  const double half = scale * z * std::sqrt(p * (1.0 - p) / n + 0.25 * z * z / (n * n));
  return {.count = count,
          .of = of,
          .value = p,
          .low = count == 0 ? 0.0 : std::max(0.0, centre - half),
          .high = count == of ? 1.0 : std::min(1.0, centre + half)};
}

Quantiles quantiles(std::vector<double> values) {
  std::ranges::sort(values);
  return {.mean = std::reduce(values.begin(), values.end()) / static_cast<double>(values.size()),
          .p5 = point(values, 0.05),
          .p50 = point(values, 0.5),
          .p95 = point(values, 0.95)};
}

}  // namespace fantail::campaign
