// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fantail::rare {

/// One random number of variance 1 in a sum.
struct Part {
  double factor = 1.0;      ///< above 0, at most 1
  bool is_student = false;  ///< with the tails of Student's t with five degrees of freedom; else normal
};

/// How probable it is that the sum of independent numbers, each times its factor, is beyond `reach` (0 to 15). Their
/// densities are folded one after the other, in cells of 0.02 up to 20: to 3 %.
[[nodiscard]] double tail_of_sum(const std::vector<Part>& parts, double reach);

}  // namespace fantail::rare
