// SPDX-License-Identifier: MIT
#include "logs/shift.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "logs/interpolator.hpp"

namespace fantail::logs {
namespace {

constexpr double coarse_step_s = 0.005;  // a tenth of a turn of a motion of 20 Hz
// From the trough to the points that bend its parabola: farther away noise matters less, but the trough is no parabola
// there.
constexpr double reach_of_trough_s = 0.02;

struct Trial {
  double mean_square = 0.0;
  std::size_t samples = 0;
};

Trial try_shift(const RollLog& a, const RollLog& b, const ShiftSearch& search, double shift_s) {
  Interpolator interpolator{b.time_s, search.longest_gap_s};
  Trial trial;
  for (std::size_t i = search.begin; i < search.end; ++i) {
    if (const auto place = interpolator.at(a.time_s[i] + shift_s)) {
      const double difference = a.roll_rate_rad_s[i] - place->of(b.roll_rate_rad_s);
      trial.mean_square += difference * difference;
      ++trial.samples;
    }
  }
  if (trial.samples > 0) {
    trial.mean_square /= static_cast<double>(trial.samples);
  }
  return trial;
}

double usual_interval(const std::vector<double>& time_s) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    intervals.push_back(time_s[i] - time_s[i - 1]);
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

}  // namespace

std::optional<FoundShift> find_shift(const RollLog& a, const RollLog& b, const ShiftSearch& search) {
  // Between two samples of B noise is averaged, and a shift of half an interval looks better than it is. In steps of
  // whole intervals every trial meets B's samples alike, and the trough between them is found by a parabola.
  const double interval_s = usual_interval(b.time_s);
  const double step_s = interval_s * std::max(std::round(coarse_step_s / interval_s), 1.0);
  const auto reach = static_cast<std::ptrdiff_t>(search.most_shift_s / step_s + 1e-9);
  std::vector<Trial> trials;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    trials.push_back(try_shift(a, b, search, static_cast<double>(k) * step_s));
  }
  const std::size_t most = std::ranges::max(trials, {}, &Trial::samples).samples;
  const auto counts = [most](const Trial& trial) { return trial.samples > 0 && 2 * trial.samples >= most; };
  std::optional<std::size_t> best;
  double worst = 0.0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (counts(trials[i])) {
      worst = std::max(worst, trials[i].mean_square);
      if (!best || trials[i].mean_square < trials[*best].mean_square) {
        best = i;
      }
    }
  }
  if (!best || worst - trials[*best].mean_square <= 1e-9 * worst) {
    return std::nullopt;
  }
  const double coarse_s = static_cast<double>(static_cast<std::ptrdiff_t>(*best) - reach) * step_s;
  const auto beside = static_cast<std::size_t>(std::max(std::round(reach_of_trough_s / step_s), 1.0));
  if (*best < beside || *best + beside >= trials.size() || !counts(trials[*best - beside]) ||
      !counts(trials[*best + beside])) {
    return FoundShift{coarse_s, true};
  }
  const double left = trials[*best - beside].mean_square;
  const double middle = trials[*best].mean_square;
  const double right = trials[*best + beside].mean_square;
  const double bend = left - 2.0 * middle + right;
  const double half_width_s = 0.5 * static_cast<double>(beside) * step_s;
  return FoundShift{coarse_s + (bend > 0.0 ? half_width_s * (left - right) / bend : 0.0), false};
}

}  // namespace fantail::logs
