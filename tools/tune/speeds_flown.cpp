// SPDX-License-Identifier: MIT
#include "tune/speeds_flown.hpp"

#include <algorithm>
#include <cstddef>

namespace fantail::tune {

SpeedsFlown speeds_flown(std::vector<double> speeds_m_s) {
  SpeedsFlown all{.range = {.lowest_m_s = std::ranges::min(speeds_m_s), .highest_m_s = std::ranges::max(speeds_m_s)}};
  std::ranges::sort(speeds_m_s);
  const auto at = [&](double share) {
    return speeds_m_s[static_cast<std::size_t>(share * static_cast<double>(speeds_m_s.size() - 1))];
  };
  all.median_m_s = at(0.5);
  constexpr int parts = 16;
  for (int i = 0; i < parts; ++i) {
    all.evenly_in_time_m_s.push_back(at((i + 0.5) / parts));
  }
  return all;
}

}  // namespace fantail::tune
