// SPDX-License-Identifier: MIT
#include "logs/interpolator.hpp"

namespace fantail::logs {

std::optional<Between> Interpolator::at(double t_s) {
  while (next_ < time_s_.size() && time_s_[next_] <= t_s) {
    ++next_;
  }
  if (next_ == 0) {
    return std::nullopt;
  }
  const std::size_t before = next_ - 1;
  if (time_s_[before] == t_s) {
    return Between{before, 0.0};
  }
  if (next_ == time_s_.size() || time_s_[next_] - time_s_[before] > longest_gap_s_) {
    return std::nullopt;
  }
  return Between{before, (t_s - time_s_[before]) / (time_s_[next_] - time_s_[before])};
}

}  // namespace fantail::logs
