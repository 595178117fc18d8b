// SPDX-License-Identifier: MIT
#include "bench/lag_fit.hpp"

#include <algorithm>
#include <cmath>

#include "bench/signal.hpp"

namespace fantail::bench {
namespace {

constexpr std::size_t fewest_readings = 100;
constexpr double least_variance_rad2 = 1e-8;  // a command that never changed by more than 0.01 deg
constexpr double shortest_lag_s = 0.001;
constexpr double longest_lag_s = 0.5;
constexpr std::size_t longest_delay = 40;
constexpr double follows = 0.05;  // less slope than this is noise, and its lag means nothing

double hold_factor(double lag_s) { return 1.0 - std::exp(-tick_s / lag_s); }

// What is left of the encoder's variance; the same sums as regress(), in one pass and without the lagged command in
// memory, because the search below does it some fifty times.
std::optional<LagFit> attempt(const Course& course, const Window& window, std::size_t delay_ticks, double lag_s) {
  const double factor = hold_factor(lag_s);
  const double offset_rad = course.command_rad.front();  // sums of small numbers lose less
  double model = 0.0;
  double n = 0.0;
  double sum_m = 0.0;
  double sum_e = 0.0;
  double sum_mm = 0.0;
  double sum_me = 0.0;
  double sum_ee = 0.0;
  for (std::size_t i = 0; i < window.end; ++i) {
    const double told = course.command_rad[i > delay_ticks ? i - delay_ticks : 0] - offset_rad;
    model += factor * (told - model);
    const double e = course.encoder_rad[i] - offset_rad;
    if (i < window.begin || std::isnan(e)) {
      continue;
    }
    n += 1.0;
    sum_m += model;
    sum_e += e;
    sum_mm += model * model;
    sum_me += model * e;
    sum_ee += e * e;
  }
  if (n < fewest_readings) {
    return std::nullopt;
  }
  const double mm = sum_mm / n - (sum_m / n) * (sum_m / n);
  const double me = sum_me / n - (sum_m / n) * (sum_e / n);
  const double ee = sum_ee / n - (sum_e / n) * (sum_e / n);
  if (mm < least_variance_rad2) {
    return std::nullopt;
  }
  return LagFit{.delay_ticks = delay_ticks, .lag_s = lag_s, .slope = me / mm, .spread = ee - me * me / mm};
}

}  // namespace

std::vector<double> lagged(const std::vector<double>& command_rad, std::size_t delay_ticks, double lag_s) {
  const double factor = hold_factor(lag_s);
  std::vector<double> result;
  result.reserve(command_rad.size());
  double model = command_rad.empty() ? 0.0 : command_rad.front();
  for (std::size_t i = 0; i < command_rad.size(); ++i) {
    model += factor * (command_rad[i > delay_ticks ? i - delay_ticks : 0] - model);
    result.push_back(model);
  }
  return result;
}

std::optional<LagFit> fit_lag(const Course& course, const Window& window) {
  if (course.size() == 0 || window.size() == 0) {
    return std::nullopt;
  }
  // A coarse grid first: between a short lag and a long one the error may have a hill.
  std::optional<LagFit> best;
  for (const double lag_s : {0.002, 0.008, 0.020, 0.050, 0.120, 0.300}) {
    for (const std::size_t delay : {std::size_t{1}, std::size_t{4}, std::size_t{12}, std::size_t{30}}) {
      const auto here = attempt(course, window, delay, lag_s);
      if (!here) {
        return std::nullopt;
      }
      if (!best || here->spread < best->spread) {
        best = here;
      }
    }
  }
  if (std::abs(best->slope) < follows) {
    return std::nullopt;
  }
  // Then downhill; delay and lag trade against each other, so the diagonals are tried too.
  std::size_t delay_step = 8;
  double lag_step = 0.3;
  while (lag_step > 0.004) {
    bool better = false;
    for (const int along : {-1, 0, 1}) {
      for (const int across : {-1, 0, 1}) {
        const auto delay = static_cast<double>(best->delay_ticks) + static_cast<double>(delay_step) * along;
        const double lag_s = std::clamp(best->lag_s * (1.0 + lag_step * across), shortest_lag_s, longest_lag_s);
        if (delay < 0.0 || delay > static_cast<double>(longest_delay) || (along == 0 && across == 0)) {
          continue;
        }
        const auto here = attempt(course, window, static_cast<std::size_t>(delay), lag_s);
        if (here && here->spread < best->spread) {
          best = here;
          better = true;
        }
      }
    }
    if (!better) {
      delay_step = std::max<std::size_t>(delay_step / 2, 1);
      lag_step /= 2.0;
    }
  }
  return best;
}

std::optional<LagFit> regress(const std::vector<double>& lagged_rad, const Course& course, const Window& window) {
  const Window both{window.begin, std::min(window.end, lagged_rad.size())};
  const LineFit line = fit_line(course, both, [&](std::size_t i) { return lagged_rad[i]; });
  if (line.readings < fewest_readings || line.variance < least_variance_rad2) {
    return std::nullopt;
  }
  return LagFit{.slope = line.slope, .spread = line.left_over / line.readings};
}

}  // namespace fantail::bench
