// SPDX-License-Identifier: MIT
#include "bench/readings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fantail::bench {
namespace {

constexpr std::size_t fewest_at_rest = 20;
constexpr std::size_t slope_ticks = 11;
constexpr std::size_t fewest_for_slope = 7;
constexpr std::size_t half_smooth = 2;     // 5 ms: short against any servo's step
constexpr std::size_t half_tracking = 10;  // 21 ms

std::optional<double> mean_around(const CanardTrace& trace, std::size_t at, std::size_t half) {
  double sum = 0.0;
  double n = 0.0;
  for (std::size_t i = at > half ? at - half : 0; i < std::min(at + half + 1, trace.size()); ++i) {
    if (!std::isnan(trace.encoder_rad[i])) {
      sum += trace.encoder_rad[i];
      n += 1.0;
    }
  }
  return n > 0.0 ? std::optional{sum / n} : std::nullopt;
}

LineFit line_over_time(const CanardTrace& trace, const Window& window) {
  return fit_line(trace, window, [&](std::size_t i) { return tick_s * static_cast<double>(i - window.begin); });
}

constexpr std::size_t fewest_readings = 100;
constexpr double least_variance_rad2 = 1e-8;  // a command that never changed by more than 0.01 deg
constexpr double shortest_lag_s = 0.001;
constexpr double longest_lag_s = 0.5;
constexpr std::size_t longest_delay = 40;
constexpr double follows = 0.05;  // less slope than this is noise, and its lag means nothing

double hold_factor(double lag_s) { return 1.0 - std::exp(-tick_s / lag_s); }

// What is left of the encoder's variance; the same sums as regress(), in one pass and without the lagged command in
// memory, because the search below does it some fifty times.
std::optional<LagFit> attempt(const CanardTrace& trace, const Window& window, std::size_t delay_ticks, double lag_s) {
  const double factor = hold_factor(lag_s);
  const double offset_rad = trace.command_rad.front();  // sums of small numbers lose less
  double model = 0.0;
  double n = 0.0;
  double sum_m = 0.0;
  double sum_e = 0.0;
  double sum_mm = 0.0;
  double sum_me = 0.0;
  double sum_ee = 0.0;
  for (std::size_t i = 0; i < window.end; ++i) {
    const double told = trace.command_rad[i > delay_ticks ? i - delay_ticks : 0] - offset_rad;
    model += factor * (told - model);
    const double e = trace.encoder_rad[i] - offset_rad;
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

std::optional<double> level_rad(const CanardTrace& trace, const Window& window) {
  std::vector<double> read;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (!std::isnan(trace.encoder_rad[i])) {
      read.push_back(trace.encoder_rad[i]);
    }
  }
  if (read.size() < fewest_at_rest) {
    return std::nullopt;
  }
  std::ranges::sort(read);
  const auto tenth = static_cast<std::ptrdiff_t>(read.size() / 10);
  return std::accumulate(read.begin() + tenth, read.end() - tenth, 0.0) /
         static_cast<double>(std::ssize(read) - 2 * tenth);
}

std::optional<Rest> rest_of(const CanardTrace& trace, const Window& window) {
  const LineFit line = line_over_time(trace, window);
  if (line.readings < fewest_at_rest) {
    return std::nullopt;
  }
  const double variance_rad2 = std::max(line.left_over, 0.0) / (line.readings - 2.0);
  return Rest{.drift_rad_s = line.slope,
              .drift_error_rad_s = std::sqrt(variance_rad2 / (line.variance * line.readings)),
              .variance_rad2 = variance_rad2,
              .readings = line.readings};
}

std::optional<double> fastest_rad_s(const CanardTrace& trace, const Window& window) {
  std::optional<double> fastest;
  for (std::size_t begin = window.begin; begin + slope_ticks <= window.end; ++begin) {
    const LineFit line = line_over_time(trace, {begin, begin + slope_ticks});
    if (line.readings >= fewest_for_slope) {
      fastest = std::max(fastest.value_or(0.0), std::abs(line.slope));
    }
  }
  return fastest;
}

std::optional<double> rise_time_s(const CanardTrace& trace, const Window& window, double from_rad, double to_rad) {
  if (from_rad == to_rad) {
    return std::nullopt;
  }
  // Backwards from the first time at 90 % to the last time at 10 % before it: noise near the start counts for nothing.
  std::optional<double> last_low_s;
  double before = 0.0;
  std::optional<std::size_t> before_at;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    const auto smooth = mean_around(trace, i, half_smooth);
    if (!smooth) {
      continue;
    }
    const double share = (*smooth - from_rad) / (to_rad - from_rad);
    const auto crossing_s = [&](double level) {
      const double step = static_cast<double>(i - *before_at);
      return tick_s * (static_cast<double>(*before_at) + step * (level - before) / (share - before));
    };
    if (before_at && before < 0.1 && share >= 0.1) {
      last_low_s = crossing_s(0.1);
    }
    if (share >= 0.9) {
      return last_low_s && before_at ? std::optional{crossing_s(0.9) - *last_low_s} : std::nullopt;
    }
    before = share;
    before_at = i;
  }
  return std::nullopt;
}

std::optional<double> largest_difference_rad(const CanardTrace& trace, const std::vector<double>& expected_rad,
                                             bool (*wanted)(Part)) {
  constexpr std::size_t length = 2 * half_tracking + 1;
  std::optional<double> largest;
  double sum = 0.0;
  std::size_t readings = 0;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (const double d = trace.encoder_rad[i] - expected_rad[i]; !std::isnan(d)) {
      sum += d;
      ++readings;
    }
    if (i >= length) {
      if (const double d = trace.encoder_rad[i - length] - expected_rad[i - length]; !std::isnan(d)) {
        sum -= d;
        --readings;
      }
    }
    if (i + 1 >= length && readings > half_tracking && wanted(trace.part[i - half_tracking])) {
      largest = std::max(largest.value_or(0.0), std::abs(sum / static_cast<double>(readings)));
    }
  }
  return largest;
}

std::optional<double> rms_difference_rad(const CanardTrace& trace, const std::vector<double>& expected_rad,
                                         bool (*wanted)(Part)) {
  double squares = 0.0;
  double readings = 0.0;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (const double d = trace.encoder_rad[i] - expected_rad[i]; !std::isnan(d) && wanted(trace.part[i])) {
      squares += d * d;
      readings += 1.0;
    }
  }
  return readings > 0.0 ? std::optional{std::sqrt(squares / readings)} : std::nullopt;
}

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

std::optional<LagFit> fit_lag(const CanardTrace& trace, const Window& window) {
  if (trace.size() == 0 || window.size() == 0) {
    return std::nullopt;
  }
  // A coarse grid first: between a short lag and a long one the error may have a hill.
  std::optional<LagFit> best;
  for (const double lag_s : {0.002, 0.008, 0.020, 0.050, 0.120, 0.300}) {
    for (const std::size_t delay : {std::size_t{1}, std::size_t{4}, std::size_t{12}, std::size_t{30}}) {
      const auto here = attempt(trace, window, delay, lag_s);
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
        const auto here = attempt(trace, window, static_cast<std::size_t>(delay), lag_s);
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

std::optional<LagFit> regress(const std::vector<double>& lagged_rad, const CanardTrace& trace, const Window& window) {
  const Window both{window.begin, std::min(window.end, lagged_rad.size())};
  const LineFit line = fit_line(trace, both, [&](std::size_t i) { return lagged_rad[i]; });
  if (line.readings < fewest_readings || line.variance < least_variance_rad2) {
    return std::nullopt;
  }
  return LagFit{.slope = line.slope, .spread = line.left_over / line.readings};
}

}  // namespace fantail::bench
