// SPDX-License-Identifier: MIT
#include "hal/stm32f4/frozen_counts.hpp"

#include <limits>

namespace fantail::hal::stm32f4 {
namespace {

constexpr std::uint8_t moves_to_trust = 10;

// There the last bit does not move, whatever the noise.
bool at_an_end(std::int16_t count) {
  return count == std::numeric_limits<std::int16_t>::max() || count == std::numeric_limits<std::int16_t>::min();
}

}  // namespace

bool FrozenCounts::update(const Counts& counts) {
  bool found = false;
  repeated_ = true;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Axis& axis = axes_[i];
    const bool same = counts[i] == last_[i] && !at_an_end(counts[i]);
    repeated_ = repeated_ && same;
    axis.run = same ? static_cast<std::uint16_t>(axis.run + 1) : std::uint16_t{0};
    if (axis.run >= limits_.one_axis) {
      axis = {.run = 0, .doubts = moves_to_trust};
      found = true;
    } else if (!same && !at_an_end(counts[i]) && axis.doubts > 0) {
      axis.doubts -= 1;
    }
  }
  last_ = counts;
  run_ = repeated_ ? static_cast<std::uint16_t>(run_ + 1) : std::uint16_t{0};
  if (run_ >= limits_.three_axes) {
    condemn();
    found = true;
  }
  return found;
}

void FrozenCounts::condemn() {
  run_ = 0;
  for (Axis& axis : axes_) {
    axis = {.run = 0, .doubts = moves_to_trust};
  }
}

}  // namespace fantail::hal::stm32f4
