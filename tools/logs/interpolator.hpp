// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fantail::logs {

/// The median distance of two samples; at least two samples.
[[nodiscard]] inline double usual_interval_s(std::span<const double> time_s) {
  std::vector<double> interval_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    interval_s.push_back(time_s[i] - time_s[i - 1]);
  }
  const auto middle = interval_s.begin() + static_cast<std::ptrdiff_t>(interval_s.size() / 2);
  std::ranges::nth_element(interval_s, middle);
  return *middle;
}

/// Where a time lies between two samples of a log: `part` of the way from sample `before` to the next.
struct Between {
  std::size_t before;
  double part;

  [[nodiscard]] double of(const std::vector<double>& values) const {
    return part == 0.0 ? values[before] : values[before] + part * (values[before + 1] - values[before]);
  }
};

/// Finds the places of times that are asked for in increasing order. Empty outside the log and between samples farther
/// apart than the longest gap: nothing is extrapolated or bridged.
class Interpolator {
 public:
  Interpolator(std::span<const double> time_s, double longest_gap_s)
      : time_s_{time_s}, longest_gap_s_{longest_gap_s * (1.0 + 1e-9)} {}  // a log every 0.1 s has no gaps of 0.1 s

  [[nodiscard]] std::optional<Between> at(double t_s) {
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

 private:
  std::span<const double> time_s_;
  double longest_gap_s_;
  std::size_t next_ = 0;  ///< first sample behind the last time that was asked for
};

}  // namespace fantail::logs
