// SPDX-License-Identifier: MIT
#include "tunnel/settling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

constexpr double left_over = 0.25;  // of the scatter, when the change counts as done

/// level + change exp(-(t - first) / time_constant)
struct Decay {
  double change = 0.0;
  double time_constant_s = 0.0;
  double scatter = 0.0;  ///< root mean square about it
};

// For one time constant the rest is a straight line in the exponential.
Decay fit(std::span<const double> time_s, std::span<const double> value, double time_constant_s,
          std::span<double> exponential) {
  std::ranges::transform(time_s, exponential.begin(),
                         [&](double t) { return std::exp(-(t - time_s.front()) / time_constant_s); });
  const Line line = fit_line(exponential, value);
  double squares = 0.0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double error = value[i] - line.offset - line.slope * exponential[i];
    squares += error * error;
  }
  return {.change = line.slope,
          .time_constant_s = time_constant_s,
          .scatter = std::sqrt(squares / static_cast<double>(value.size()))};
}

Decay fit(std::span<const double> time_s, std::span<const double> value) {
  constexpr int trials = 100;
  const double length_s = time_s.back() - time_s.front();
  const double shortest_s = 0.2 * length_s / static_cast<double>(time_s.size());
  std::vector<double> exponential(time_s.size());
  Decay best;
  for (int i = 0; i <= trials; ++i) {
    const double time_constant_s = shortest_s * std::pow(0.5 * length_s / shortest_s, i / double{trials});
    const Decay decay = fit(time_s, value, time_constant_s, exponential);
    if (i == 0 || decay.scatter < best.scatter) {
      best = decay;
    }
  }
  return best;
}

}  // namespace

std::size_t settled_from(std::span<const double> time_s, std::span<const double> value, double least_scatter) {
  constexpr std::size_t fewest = 4;  // level, change, time constant, and one to tell how well they fit
  if (value.size() < fewest) {
    return value.size();
  }
  const Moments end = moments(value.last(std::max<std::size_t>(value.size() / 3, 2)));
  const double scatter = std::max(end.standard_deviation, least_scatter);
  const double step = std::abs(value.front() - end.mean);
  if (step <= 3.0 * scatter) {
    return 0;
  }
  const auto half_done = std::ranges::find_if(value, [&](double v) { return std::abs(v - end.mean) < 0.5 * step; });
  const auto first = static_cast<std::size_t>(half_done - value.begin());
  if (value.size() < first + fewest) {
    return value.size();
  }
  const Decay decay = fit(time_s.subspan(first), value.subspan(first));
  const double allowed = left_over * std::max(decay.scatter, least_scatter);
  if (std::abs(decay.change) <= allowed) {
    return first;
  }
  const double settled_s =
      time_s[first] + (allowed > 0.0 ? decay.time_constant_s * std::log(std::abs(decay.change) / allowed)
                                     : time_s.back() - time_s[first]);
  return static_cast<std::size_t>(std::ranges::lower_bound(time_s, settled_s) - time_s.begin());
}

}  // namespace fantail::tunnel
