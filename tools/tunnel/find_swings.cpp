// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tunnel/swing.hpp"

namespace fantail::tunnel {
namespace {

struct HalfWave {
  double begin_s;
  double end_s;
  double top_s;
  double top;  ///< size
};

std::vector<double> smoothed(const SwingLog& log, double width_s) {
  std::vector<double> result(log.value.size());
  std::size_t first = 0;
  std::size_t last = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < log.value.size(); ++i) {
    while (last < log.value.size() && log.time_s[last] <= log.time_s[i] + 0.5 * width_s) {
      sum += log.value[last++];
    }
    while (log.time_s[first] < log.time_s[i] - 0.5 * width_s) {
      sum -= log.value[first++];
    }
    result[i] = sum / static_cast<double>(last - first);
  }
  return result;
}

std::vector<HalfWave> half_waves(const SwingLog& log) {
  constexpr double width_s = 0.1;  // far shorter than any swing of a rocket in a tunnel
  std::vector<double> value = smoothed(log, width_s);
  std::vector<double> sorted = value;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double middle = sorted[sorted.size() / 2];
  std::vector<HalfWave> waves;
  for (std::size_t i = 0; i < value.size();) {
    const bool above = value[i] > middle;
    HalfWave wave{.begin_s = log.time_s[i], .end_s = log.time_s[i], .top_s = log.time_s[i], .top = 0.0};
    for (; i < value.size() && (value[i] > middle) == above; ++i) {
      wave.end_s = log.time_s[i];
      if (std::abs(value[i] - middle) > wave.top) {
        wave.top = std::abs(value[i] - middle);
        wave.top_s = log.time_s[i];
      }
    }
    waves.push_back(wave);
  }
  return waves;
}

}  // namespace

std::vector<SwingStretch> find_swings(const SwingLog& log) {
  constexpr double jump = 2.0;
  constexpr double least_share = 0.2;
  constexpr double lost_share = 0.03;
  const std::vector<HalfWave> waves = half_waves(log);
  const double highest = std::ranges::max(waves, {}, &HalfWave::top).top;
  std::vector<SwingStretch> found;
  double before = 0.0;
  double first = 0.0;
  for (const HalfWave& wave : waves) {
    if (wave.top >= least_share * highest && wave.top >= jump * before) {
      if (!found.empty()) {
        found.back().end_s = std::min(found.back().end_s, wave.begin_s);
      }
      found.push_back({.begin_s = wave.top_s, .end_s = log.time_s.back()});
      first = wave.top;
    } else if (!found.empty() && wave.top < lost_share * first) {
      found.back().end_s = std::min(found.back().end_s, wave.begin_s);
    }
    before = wave.top;
  }
  return found;
}

}  // namespace fantail::tunnel
