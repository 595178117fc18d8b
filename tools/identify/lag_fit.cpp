// SPDX-License-Identifier: MIT
#include "identify/lag_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace fantail::identify {
namespace {

constexpr double stride_s = 0.005;
constexpr double fine_enough_s = 0.0001;

// The same samples for every lag that is tried, or the comparison would favour the shortest record.
Window with_room(const logs::RollLog& log, Window window) {
  const double first = log.time_s.front() + largest_fitted_lag_s;
  const double last = log.time_s.back() - largest_fitted_lag_s;
  window.from_s = std::max(window.from_s.value_or(first), first);
  window.to_s = std::min(window.to_s.value_or(last), last);
  return window;
}

}  // namespace

LagFit fit_lag(const logs::RollLog& log, const Window& window, const RecordOptions& record_options,
               const Airframe& airframe, const NodeChoice& nodes, const Options& options) {
  Options quick = options;
  quick.method = Method::continuous;
  quick.closed_loop.reset();
  quick.with_uncertainty = false;
  quick.with_error_map = false;
  // One choice of nodes for all lags; the most that could be chosen leaves the least of the disturbance in the error.
  const auto* automatic = std::get_if<AutomaticNodes>(&nodes);
  quick.nodes = automatic != nullptr ? NodeChoice{EvenNodes{automatic->most}} : nodes;
  const Window inside = with_room(log, window);
  const auto error = [&](double lag_s) {
    RecordOptions shifted = record_options;
    shifted.lag_s = lag_s;
    return identify(make_record(log, inside, shifted), airframe, quick).simulation.rms_angle_error_rad;
  };

  double best_s = 0.0;
  double least = error(0.0);
  for (int i = 1; i * stride_s < largest_fitted_lag_s + 0.5 * stride_s; ++i) {
    for (const double lag_s : {-i * stride_s, i * stride_s}) {
      if (const double e = error(lag_s); e < least) {
        least = e;
        best_s = lag_s;
      }
    }
  }
  const bool at_the_edge = std::abs(best_s) > largest_fitted_lag_s - 0.5 * stride_s;
  // Golden section between the neighbours of the best.
  constexpr double golden = std::numbers::phi - 1.0;
  double low = std::max(best_s - stride_s, -largest_fitted_lag_s);
  double high = std::min(best_s + stride_s, largest_fitted_lag_s);
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double left_error = error(left);
  double right_error = error(right);
  while (high - low > fine_enough_s) {
    if (left_error < right_error) {
      high = right;
      right = left;
      right_error = left_error;
      left = high - golden * (high - low);
      left_error = error(left);
    } else {
      low = left;
      left = right;
      left_error = right_error;
      right = low + golden * (high - low);
      right_error = error(right);
    }
  }
  return {.lag_s = 0.5 * (low + high), .at_the_edge = at_the_edge};
}

}  // namespace fantail::identify
