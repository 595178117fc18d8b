// SPDX-License-Identifier: MIT
#include "listen/log_height.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fantail::listen {
namespace {

constexpr double median_window_s = 0.5;
constexpr double pad_window_s = 1.0;
// A height that still rises at the end of the log is no apogee.
constexpr double least_after_s = 0.5;

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

LogHeight log_height(const Signal& height, double lift_off_s) {
  LogHeight result{.above_pad = height};
  if (!height.is_there()) {
    return result;
  }
  const double zero = zero_of(height, lift_off_s);
  std::ranges::for_each(result.above_pad.value, [&](double& value) { value -= zero; });
  const std::vector<double>& time_s = height.time_s;
  std::vector<double> window;
  std::optional<double> best;
  for (std::size_t i = 0, begin = 0, end = 0; i < time_s.size(); ++i) {
    while (time_s[begin] < time_s[i] - 0.5 * median_window_s) {
      ++begin;
    }
    while (end < time_s.size() && time_s[end] <= time_s[i] + 0.5 * median_window_s) {
      ++end;
    }
    if (time_s[i] < lift_off_s) {
      continue;
    }
    window.assign(result.above_pad.value.begin() + static_cast<std::ptrdiff_t>(begin),
                  result.above_pad.value.begin() + static_cast<std::ptrdiff_t>(end));
    const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
    std::ranges::nth_element(window, middle);
    if (!best || *middle > *best) {
      best = *middle;
      result.apogee_s = time_s[i];
      result.apogee_m = *middle;
    }
  }
  if (result.apogee_s && time_s.back() - *result.apogee_s < least_after_s) {
    result.apogee_s.reset();
  }
  return result;
}

}  // namespace fantail::listen
