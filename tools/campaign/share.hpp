// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace fantail::campaign {

/// How often something happened, and what that says about how often it happens.
struct Share {
  std::size_t count = 0;
  std::size_t of = 0;
  double value = 0.0;
  double low = 0.0;  ///< 95 % interval (Wilson, 1927): sensible also where all or none did
  double high = 1.0;
};

/// Without anything to count nothing is known: 0 to 1.
[[nodiscard]] Share share(std::size_t count, std::size_t of);

/// Mean and the points below which 5, 50 and 95 % of the values lie.
struct Quantiles {
  double mean = 0.0;
  double p5 = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
};

/// Below it lies this share of the values, of which there is at least one. Between two values a point lies on the
/// straight line, so that the least is 0 % and the largest 100 %.
[[nodiscard]] double point_above(std::vector<double> values, double share_below);

/// Likewise.
[[nodiscard]] Quantiles quantiles(std::vector<double> values);

}  // namespace fantail::campaign
