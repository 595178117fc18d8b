// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace fantail::identify {

struct Span {
  double low;
  double high;
};

/// Where a function is least within a span, to about `tolerance` times the distance of two places: looked for at evenly
/// spaced places first, so that a side valley is not taken for the deepest, then by parabolas and golden sections
/// (Brent) between the neighbours of the best.
[[nodiscard]] double least_over(const std::function<double(double)>& function, Span span, int places,
                                double tolerance = 1e-7);

}  // namespace fantail::identify
