// SPDX-License-Identifier: MIT
#include "sim/disturbance.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace fantail::sim {

Disturbance::Disturbance(std::vector<DisturbanceNode> nodes) : nodes_{std::move(nodes)} {
  std::vector<double> times_s;
  for (const DisturbanceNode& node : nodes_) {
    if (!std::isfinite(node.time_s) || !std::isfinite(node.angle_rad)) {
      throw std::invalid_argument{"disturbance: times and angles must be finite"};
    }
    if (!times_s.empty() && node.time_s <= times_s.back()) {
      throw std::invalid_argument{"disturbance: times must strictly increase"};
    }
    times_s.push_back(node.time_s);
  }
  if (nodes_.size() < 2) {
    return;
  }
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double slope = (nodes_[i + 1].angle_rad - nodes_[i].angle_rad) / (nodes_[i + 1].time_s - nodes_[i].time_s);
    slopes_rad_s_.push_back(std::isfinite(slope) ? slope : 0.0);  // too steep for a number: a step
  }
  index_ = SegmentIndex{std::move(times_s)};
}

}  // namespace fantail::sim
