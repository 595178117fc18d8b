// SPDX-License-Identifier: MIT
#include "identify/estimate.hpp"

#include <cmath>

namespace fantail::identify {

std::vector<double> Axis::values() const {
  // Counted, not summed up: 5 + 10 * 0.1 is 6, ten sums of 0.1 are not.
  const auto steps = static_cast<int>(std::floor((last - first) / step + 1e-9));
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    all.push_back(first + static_cast<double>(i) * step);
  }
  return all;
}

}  // namespace fantail::identify
