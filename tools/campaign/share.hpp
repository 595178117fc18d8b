// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "result/field.hpp"

namespace fantail::campaign {

using result::Share;  ///< its interval: Wilson, 1927; sensible also where all or none did

/// Without anything to count nothing is known: 0 to 1.
[[nodiscard]] Share share(std::size_t count, std::size_t of);

/// Between two values a point lies on the straight line, so that the least is 0 % and the largest 100 %.
using Quantiles = result::Spread;

/// Of at least one value.
[[nodiscard]] Quantiles quantiles(std::vector<double> values);

}  // namespace fantail::campaign
