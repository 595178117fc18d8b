// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hal/clock.hpp"

namespace fantail::sim {

/// Hands on samples a fixed time after they were measured. `Sample` carries its own `time`, and keeps it: a late
/// sample says honestly how old it is.
template <typename Sample>
class DelayLine {
 public:
  /// Up to 20 ms at 1 kHz.
  explicit DelayLine(hal::Microseconds delay) : delay_{delay} {}

  /// Where to write the sample measured next; times never go back. When more are on their way than fit, the oldest of
  /// them is lost. Written in place: a copy of freshly written counts stalls the processor for longer than it takes
  /// to make them.
  [[nodiscard]] Sample& next() {
    if (delay_.count() == 0) {
      return latest_;
    }
    if (waiting_ == line_.size()) {
      pop();
    }
    return line_[(first_ + waiting_++) % line_.size()];
  }

  /// The newest sample that has arrived by `now`; before the first, a default one.
  [[nodiscard]] const Sample& arrived(hal::Microseconds now) {
    while (waiting_ > 0 && line_[first_].time + delay_ <= now) {
      latest_ = line_[first_];
      pop();
    }
    return latest_;
  }

  /// What arrived last, again: a device that hangs.
  [[nodiscard]] const Sample& repeated() const { return latest_; }

 private:
  void pop() {
    first_ = (first_ + 1) % line_.size();
    --waiting_;
  }

  hal::Microseconds delay_;
  Sample latest_{};
  std::size_t first_ = 0;
  std::size_t waiting_ = 0;
  std::array<Sample, 32> line_{};
};

}  // namespace fantail::sim
