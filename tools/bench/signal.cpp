// SPDX-License-Identifier: MIT
#include "bench/signal.hpp"

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

std::optional<double> mean_around(const Course& course, std::size_t at, std::size_t half) {
  double sum = 0.0;
  double n = 0.0;
  for (std::size_t i = at > half ? at - half : 0; i < std::min(at + half + 1, course.size()); ++i) {
    if (!std::isnan(course.encoder_rad[i])) {
      sum += course.encoder_rad[i];
      n += 1.0;
    }
  }
  return n > 0.0 ? std::optional{sum / n} : std::nullopt;
}

LineFit line_over_time(const Course& course, const Window& window) {
  return fit_line(course, window, [&](std::size_t i) { return tick_s * static_cast<double>(i - window.begin); });
}

}  // namespace

std::optional<double> level_rad(const Course& course, const Window& window) {
  std::vector<double> read;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (!std::isnan(course.encoder_rad[i])) {
      read.push_back(course.encoder_rad[i]);
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

std::optional<Rest> rest_of(const Course& course, const Window& window) {
  const LineFit line = line_over_time(course, window);
  if (line.readings < fewest_at_rest) {
    return std::nullopt;
  }
  return Rest{.drift_rad_s = line.slope,
              .variance_rad2 = std::max(line.left_over, 0.0) / (line.readings - 2.0),
              .readings = line.readings};
}

std::optional<double> fastest_rad_s(const Course& course, const Window& window) {
  std::optional<double> fastest;
  for (std::size_t begin = window.begin; begin + slope_ticks <= window.end; ++begin) {
    const LineFit line = line_over_time(course, {begin, begin + slope_ticks});
    if (line.readings >= fewest_for_slope) {
      fastest = std::max(fastest.value_or(0.0), std::abs(line.slope));
    }
  }
  return fastest;
}

std::optional<double> rise_time_s(const Course& course, const Window& window, double from_rad, double to_rad) {
  if (from_rad == to_rad) {
    return std::nullopt;
  }
  // Backwards from the first time at 90 % to the last time at 10 % before it: noise near the start counts for nothing.
  std::optional<double> last_low_s;
  double before = 0.0;
  std::optional<std::size_t> before_at;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    const auto smooth = mean_around(course, i, half_smooth);
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

std::optional<double> largest_difference_rad(const Course& course, const std::vector<double>& expected_rad,
                                             bool (*wanted)(Part)) {
  constexpr std::size_t length = 2 * half_tracking + 1;
  std::optional<double> largest;
  double sum = 0.0;
  std::size_t readings = 0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (const double d = course.encoder_rad[i] - expected_rad[i]; !std::isnan(d)) {
      sum += d;
      ++readings;
    }
    if (i >= length) {
      if (const double d = course.encoder_rad[i - length] - expected_rad[i - length]; !std::isnan(d)) {
        sum -= d;
        --readings;
      }
    }
    if (i + 1 >= length && readings > half_tracking && wanted(course.part[i - half_tracking])) {
      largest = std::max(largest.value_or(0.0), std::abs(sum / static_cast<double>(readings)));
    }
  }
  return largest;
}

}  // namespace fantail::bench
