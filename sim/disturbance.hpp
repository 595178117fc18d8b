// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/segment_index.hpp"

namespace fantail::sim {

/// One corner of the disturbance; what time zero is, the user of the list says.
struct DisturbanceNode {
  double time_s;
  double angle_rad;  ///< equivalent fin offset: the canard deflection that would make the same roll moment
};

/// The equivalent fin offset over time (Bryson et al. 2016, Eq 4-8): straight lines between nodes, constant before the
/// first and after the last; zero without nodes.
class Disturbance {
 public:
  Disturbance() = default;

  /// Throws std::invalid_argument unless all numbers are finite and the times strictly increase.
  explicit Disturbance(std::vector<DisturbanceNode> nodes);

  /// Any finite time, in any order.
  [[nodiscard]] double at(double time_s) const {
    if (nodes_.empty()) {
      return 0.0;
    }
    if (time_s <= nodes_.front().time_s) {
      return nodes_.front().angle_rad;
    }
    if (time_s >= nodes_.back().time_s) {
      return nodes_.back().angle_rad;
    }
    const std::size_t i = index_.segment(time_s);
    return nodes_[i].angle_rad + slopes_rad_s_[i] * (time_s - nodes_[i].time_s);
  }

 private:
  std::vector<DisturbanceNode> nodes_;
  std::vector<double> slopes_rad_s_;
  SegmentIndex index_;
};

}  // namespace fantail::sim
