// SPDX-License-Identifier: MIT
#include "report/extent.hpp"

#include <algorithm>

namespace fantail::report {

bool Extent::covers(double time_s) const {
  constexpr double near_s = RunningExtent::shortest_hole_s;
  return time_s > begin_s - near_s && time_s < end_s + near_s &&
         std::ranges::none_of(
             holes, [&](const Hole& hole) { return time_s > hole.from_s + near_s && time_s < hole.to_s - near_s; });
}

bool Extent::is_thin() const { return usual_step_s > 1.5 * RunningExtent::shortest_hole_s; }

void RunningExtent::add(double time_s) {
  if (rows_ == 0) {
    first_s_ = time_s;
  } else if (time_s - last_s_ > shortest_hole_s) {
    steps_.push_back({.from_s = last_s_, .to_s = time_s});
  }
  rows_ += 1;
  last_s_ = time_s;
}

Extent RunningExtent::extent(const flight::Clock& clock) const {
  return extent(clock, rows_ > 1 ? (clock(last_s_) - clock(first_s_)) / static_cast<double>(rows_ - 1) : 0.0);
}

Extent RunningExtent::extent(const flight::Clock& clock, double usual_step_s) const {
  Extent result{.begin_s = clock(first_s_), .end_s = clock(last_s_), .usual_step_s = usual_step_s};
  const double longest_s = std::clamp(3.0 * usual_step_s, shortest_hole_s, longest_step_s);
  for (const Hole& step : steps_) {
    if (step.to_s - step.from_s > longest_s) {
      result.holes.push_back({.from_s = clock(step.from_s), .to_s = clock(step.to_s)});
    }
  }
  return result;
}

}  // namespace fantail::report
