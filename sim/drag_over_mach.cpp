// SPDX-License-Identifier: MIT
#include "sim/drag_over_mach.hpp"

#include <algorithm>
#include <cstddef>

namespace fantail::sim {

double DragOverMach::at(double mach_number) const {
  if (mach.empty()) {
    return 1.0;
  }
  const auto above = std::ranges::upper_bound(mach, mach_number);
  if (above == mach.begin()) {
    return factor.front();
  }
  if (above == mach.end()) {
    return factor.back();
  }
  const auto i = static_cast<std::size_t>(above - mach.begin());
  const double share = (mach_number - mach[i - 1]) / (mach[i] - mach[i - 1]);
  return factor[i - 1] + share * (factor[i] - factor[i - 1]);
}

}  // namespace fantail::sim
