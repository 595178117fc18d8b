// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <vector>

#include "listen/sensors.hpp"

namespace fantail::listen {
namespace {

constexpr double median_window_s = 0.5;
constexpr double rounding = 1e-9;  // so that evenly sampled windows have equally many samples
constexpr double pad_window_s = 1.0;
// A height that still rises at the end of the log is no apogee.
constexpr double least_after_s = 0.5;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// A barometer says nothing new within 5 ms, and a table of 1 kHz would take long.
Signal thinned(const Signal& height) {
  constexpr double closest_s = 0.005;
  Signal kept;
  for (std::size_t i = 0; i < height.time_s.size(); ++i) {
    if (!kept.is_there() || height.time_s[i] - kept.time_s.back() >= closest_s - rounding) {
      kept.time_s.push_back(height.time_s[i]);
      kept.value.push_back(height.value[i]);
    }
  }
  return kept;
}

double zero_of(const Signal& height, double lift_off_s) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < height.time_s.size() && height.time_s[i] < lift_off_s; ++i) {
    if (height.time_s[i] >= lift_off_s - pad_window_s) {
      sum += height.value[i];
      ++count;
    }
  }
  return count == 0 ? height.value.front() : sum / static_cast<double>(count);
}

}  // namespace

LogHeight log_height(const Signal& height, std::optional<double> lift_off_s, std::optional<double> until_s) {
  LogHeight result{.above_pad = height};
  if (!height.is_there()) {
    return result;
  }
  const double zero = lift_off_s ? zero_of(height, *lift_off_s) : height.value.front();
  std::ranges::for_each(result.above_pad.value, [&](double& value) { value -= zero; });
  const auto is_early = [&](double time_s) { return time_s > *lift_off_s && time_s < *lift_off_s + height_within_s; };
  if (!lift_off_s || std::ranges::none_of(height.time_s, is_early)) {
    return result;
  }
  const Signal samples = thinned(result.above_pad);
  const std::vector<double>& time_s = samples.time_s;
  std::vector<double> window;
  std::optional<double> best;
  double first_s = 0.0;
  bool is_on_top = false;
  for (std::size_t i = 0, begin = 0, end = 0; i < time_s.size(); ++i) {
    while (time_s[begin] < time_s[i] - 0.5 * median_window_s - rounding) {
      ++begin;
    }
    while (end < time_s.size() && time_s[end] <= time_s[i] + 0.5 * median_window_s + rounding) {
      ++end;
    }
    if (time_s[i] < *lift_off_s || (until_s && time_s[i] >= *until_s)) {
      continue;
    }
    window.assign(samples.value.begin() + static_cast<std::ptrdiff_t>(begin),
                  samples.value.begin() + static_cast<std::ptrdiff_t>(end));
    if (const double here = median(window); !best || here > *best) {
      best = here;
      first_s = time_s[i];
      result.apogee_s = first_s;
      result.apogee_m = here;
      is_on_top = true;
    } else if (is_on_top &&
               here > *best - rounding) {  // medians around the top are often equal: apogee is in their middle
      result.apogee_s = 0.5 * (first_s + time_s[i]);
    } else {
      is_on_top = false;
    }
  }
  if (result.apogee_s && time_s.back() - *result.apogee_s < least_after_s) {
    result.apogee_s.reset();
  }
  return result;
}

}  // namespace fantail::listen
