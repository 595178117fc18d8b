// SPDX-License-Identifier: MIT
#include "distributions/shares.hpp"

#include <algorithm>
#include <cmath>

#include "distributions/quantiles.hpp"

namespace fantail::distributions {
namespace {

constexpr double miss = 0.05;

/// Between a share that is in and one that is out.
template <typename IsIn>
double edge(double in, double out, IsIn is_in) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (in + out);
    (is_in(middle) ? in : out) = middle;
  }
  return in;
}

}  // namespace

Bounds wilson(std::uint64_t count, std::uint64_t of) {
  if (of == 0) {
    return {};
  }
  constexpr double z = normal_975;
  const auto n = static_cast<double>(of);
  const double p = static_cast<double>(count) / n;
  const double scale = 1.0 / (1.0 + z * z / n);
  const double centre = scale * (p + 0.5 * z * z / n);
  const double half = scale * z * std::sqrt(p * (1.0 - p) / n + 0.25 * z * z / (n * n));
  return {.low = count == 0 ? 0.0 : std::max(0.0, centre - half),
          .high = count == of ? 1.0 : std::min(1.0, centre + half)};
}

Bounds confidence_sequence(std::uint64_t count, std::uint64_t of) {
  const auto yes = static_cast<double>(count);
  const auto no = static_cast<double>(of - count);
  // Logarithm of the mean likelihood over all shares.
  const double mixture = std::lgamma(yes + 1.0) + std::lgamma(no + 1.0) - std::lgamma(yes + no + 2.0);
  const auto is_in = [&](double share) {
    const double likelihood = (yes > 0.0 ? yes * std::log(share) : 0.0) + (no > 0.0 ? no * std::log1p(-share) : 0.0);
    return mixture - likelihood < -std::log(miss);
  };
  const double seen = of == 0 ? 0.5 : yes / (yes + no);
  return {.low = is_in(0.0) ? 0.0 : edge(seen, 0.0, is_in), .high = is_in(1.0) ? 1.0 : edge(seen, 1.0, is_in)};
}

double upper_bound_95(std::uint64_t count, std::uint64_t of) {
  if (count >= of) {
    return 1.0;
  }
  const auto n = static_cast<double>(of);
  if (count == 0) {
    return -std::expm1(std::log(0.05) / n);
  }
  // At the bound, at most so many come with a probability of 5 %.
  const auto k = static_cast<double>(count);
  return beta_quantile(0.95, k + 1.0, n - k);
}

}  // namespace fantail::distributions
