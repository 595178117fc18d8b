// SPDX-License-Identifier: MIT
#include "tunnel/unsteadiness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "tunnel/statistics.hpp"

namespace fantail::tunnel {

std::optional<Unsteadiness> unsteadiness(const TunnelLog& wind, const SteadySegments& steady, double begin_s,
                                         double end_s) {
  constexpr std::size_t fewest_readings = 5;
  const auto index_of = [&wind](auto place) { return static_cast<std::size_t>(place - wind.time_s.begin()); };
  std::size_t first = index_of(std::ranges::lower_bound(wind.time_s, begin_s));
  std::size_t count = index_of(std::ranges::upper_bound(wind.time_s, end_s)) - first;
  const auto around = std::ranges::find_if(
      steady.found, [&](const SteadySegment& segment) { return segment.begin_s < end_s && segment.end_s > begin_s; });
  if (around != steady.found.end()) {
    first = around->first;
    count = around->count;
  }
  if (count < fewest_readings) {
    return std::nullopt;
  }
  const Moments speed = moments(std::span{wind.wind_speed_m_s}.subspan(first, count));
  if (speed.mean <= 0.0) {
    return std::nullopt;
  }
  const double rounding_m_s = rounding_deviation(rounding_of(wind.wind_speed_m_s));
  const double variance = speed.standard_deviation * speed.standard_deviation - rounding_m_s * rounding_m_s;
  return Unsteadiness{.share = std::sqrt(std::max(variance, 0.0)) / speed.mean,
                      .rounding_share = rounding_m_s / speed.mean};
}

}  // namespace fantail::tunnel
