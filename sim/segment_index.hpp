// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace fantail::sim {

/// Finds between which two of a list of times a given time lies, in about constant time and for any order of questions:
/// the span is cut into equal slots, and each slot knows the segment at its left edge. Remembers nothing between
/// questions, so one index may serve several threads.
class SegmentIndex {
 public:
  SegmentIndex() = default;

  /// Times in seconds, finite and strictly increasing (the caller has checked), at least two.
  explicit SegmentIndex(std::vector<double> times_s) : times_s_{std::move(times_s)} {
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

  /// The i with times[i] <= time < times[i + 1]. Only for times within [first, last).
  [[nodiscard]] std::size_t segment(double time_s) const {
    const auto slot = static_cast<std::size_t>((time_s - times_s_.front()) * slots_per_s_);
    std::size_t i = first_in_slot_[slot];
    // Rounding may put a time that lies on the edge of a slot one slot too far; stepping back costs nothing.
    while (time_s < times_s_[i]) {
      --i;
    }
    while (time_s >= times_s_[i + 1]) {
      ++i;
    }
    return i;
  }

  [[nodiscard]] const std::vector<double>& times_s() const { return times_s_; }

 private:
  std::vector<double> times_s_;
  std::vector<std::uint32_t> first_in_slot_;
  double slots_per_s_ = 0.0;
};

}  // namespace fantail::sim
