// SPDX-License-Identifier: MIT
#include "sim/segment_index.hpp"

#include <algorithm>
#include <utility>

namespace fantail::sim {

SegmentIndex::SegmentIndex(std::vector<double> times_s) : times_s_{std::move(times_s)} {
  // Four slots a segment: evenly spaced times are found at once. Lists with one very short segment degrade to a walk.
  const std::size_t slots = 4 * times_s_.size();
  const double span_s = times_s_.back() - times_s_.front();
  // Times a denormal number apart would need more slots a second than a double can count.
  slots_per_s_ = std::min(static_cast<double>(slots) / span_s, 1e300);
  first_in_slot_.reserve(slots + 1);
  std::size_t i = 0;
  // One slot more than the span holds: rounding may number the last instant `slots`.
  for (std::size_t slot = 0; slot <= slots; ++slot) {
    const double edge_s = times_s_.front() + static_cast<double>(slot) / slots_per_s_;
    while (i + 2 < times_s_.size() && edge_s >= times_s_[i + 1]) {
      ++i;
    }
    first_in_slot_.push_back(static_cast<std::uint32_t>(i));
  }
}

}  // namespace fantail::sim
