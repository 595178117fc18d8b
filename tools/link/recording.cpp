// SPDX-License-Identifier: MIT
#include "link/recording.hpp"

namespace fantail::link {

bool Recording::add(const Tick& tick) {
  if (!ticks_.empty()) {
    // Unsigned: the difference of two far numbers must not overflow.
    const auto since_first =
        static_cast<std::uint64_t>(tick.number) - static_cast<std::uint64_t>(ticks_.front().number);
    if (tick.number <= ticks_.back().number || since_first >= longest_) {
      ++refused_;
      return false;
    }
  } else if (longest_ == 0) {
    ++refused_;
    return false;
  }
  ticks_.push_back(tick);
  return true;
}

std::size_t Recording::lost_ticks() const {
  if (ticks_.empty()) {
    return 0;
  }
  return static_cast<std::size_t>(ticks_.back().number - ticks_.front().number) + 1 - ticks_.size();
}

}  // namespace fantail::link
