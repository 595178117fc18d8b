// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "result/field.hpp"

namespace fantail::campaign {

using result::Share;  ///< its interval: Wilson, 1927; sensible also where all or none did

/// Without anything to count nothing is known: 0 to 1.
[[nodiscard]] Share share(std::size_t count, std::size_t of);

using Quantiles = result::Spread;

/// Below it lies this share of the values, of which there is at least one. Between two values a point lies on the
/// straight line, so that the least is 0 % and the largest 100 %.
[[nodiscard]] double point_above(std::vector<double> values, double share_below);

/// Likewise.
[[nodiscard]] Quantiles quantiles(std::vector<double> values);

}  // namespace fantail::campaign
