// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim/segment_index.hpp"

namespace fantail::sim {

/// A curve through points, a cubic between two neighbours: its slope has no jumps, and between two points it stays
/// between their values, so that it has no hump that the points do not have (slopes after Fritsch and Butland, SIAM J.
/// Sci. Stat. Comput. 5, 1984). Beyond the first and the last point it is constant.
class MonotoneCurve {
 public:
  struct Here {
    double value;
    double slope_per_s;
    double curvature_per_s2;
  };

  /// Times finite and strictly increasing, at least two; as many values.
  MonotoneCurve(std::vector<double> times_s, std::vector<double> values)
      : index_{std::move(times_s)}, values_{std::move(values)}, slopes_(values_.size(), 0.0) {
    const std::size_t last = values_.size() - 1;
    slopes_[0] = secant(0);
    slopes_[last] = secant(last - 1);
    for (std::size_t i = 1; i < last; ++i) {
      const double before = secant(i - 1);
      const double after = secant(i);
      if (before * after > 0.0) {
        // The harmonic mean, in which the farther neighbour counts less.
        const double span_before_s = span_s(i - 1);
        const double span_after_s = span_s(i);
        const double w1 = 2.0 * span_after_s + span_before_s;
        const double w2 = span_after_s + 2.0 * span_before_s;
        slopes_[i] = (w1 + w2) / (w1 / before + w2 / after);
      }
    }
  }

  [[nodiscard]] Here at(double time_s) const {
    const std::vector<double>& times_s = index_.times_s();
    if (!(time_s >= times_s.front())) {
      return {values_.front(), 0.0, 0.0};
    }
    if (!(time_s < times_s.back())) {
      return {values_.back(), 0.0, 0.0};
    }
    const std::size_t i = index_.segment(time_s);
    const double h = span_s(i);
    const double x = time_s - times_s[i];
    const double mean = secant(i);
    const double c2 = (3.0 * mean - 2.0 * slopes_[i] - slopes_[i + 1]) / h;
    const double c3 = (slopes_[i] + slopes_[i + 1] - 2.0 * mean) / (h * h);
    return {values_[i] + x * (slopes_[i] + x * (c2 + x * c3)), slopes_[i] + x * (2.0 * c2 + 3.0 * x * c3),
            2.0 * c2 + 6.0 * x * c3};
  }

  [[nodiscard]] const std::vector<double>& times_s() const { return index_.times_s(); }

 private:
  [[nodiscard]] double span_s(std::size_t i) const { return index_.times_s()[i + 1] - index_.times_s()[i]; }
  [[nodiscard]] double secant(std::size_t i) const { return (values_[i + 1] - values_[i]) / span_s(i); }

  SegmentIndex index_;
  std::vector<double> values_;
  std::vector<double> slopes_;
};

}  // namespace fantail::sim
