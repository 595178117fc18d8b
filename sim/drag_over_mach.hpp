// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fantail::sim {

/// A factor on the drag area over the Mach number: straight lines between its points, the ends held. No points: one
/// everywhere. Both lists are of one length, and the Mach numbers increase.
struct DragOverMach {
  std::vector<double> mach{};
  std::vector<double> factor{};

  [[nodiscard]] bool is_there() const { return !mach.empty(); }
  /// Mach number not negative.
  [[nodiscard]] double at(double mach_number) const;
};

}  // namespace fantail::sim
