// SPDX-License-Identifier: MIT
#include "fantail/gap_curves.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "report/numbers.hpp"

namespace fantail::tool {

GapCurves::GapCurves(const std::vector<double>& time_s) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    intervals.push_back(time_s[i] - time_s[i - 1]);
  }
  std::ranges::sort(intervals);
  const double longest = intervals.empty() ? 0.0 : 5.0 * intervals[intervals.size() / 2];
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (i > 0 && time_s[i] - time_s[i - 1] > longest) {
      gaps_.push_back(i);
      time_s_.push_back(0.5 * (time_s[i - 1] + time_s[i]));
    }
    time_s_.push_back(time_s[i]);
  }
}

plot::Series GapCurves::curve(std::string name, plot::Role role, const std::vector<double>& values,
                              double scale) const {
  plot::Series series{.name = std::move(name), .role = role, .x = time_s_};
  auto gap = gaps_.begin();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (gap != gaps_.end() && *gap == i) {
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
      ++gap;
    }
    series.y.push_back(scale * values[i]);
  }
  return series;
}

plot::Series GapCurves::in_degrees(std::string name, plot::Role role, const std::vector<double>& values_rad) const {
  return curve(std::move(name), role, values_rad, report::degrees(1.0));
}

}  // namespace fantail::tool
