// SPDX-License-Identifier: MIT
#include "hal/stm32f4/sample_edges.hpp"

#include <algorithm>

namespace fantail::hal::stm32f4 {
namespace {

constexpr std::uint32_t period_us = 1'000;
constexpr std::uint32_t most_off_us = 50;
constexpr std::uint32_t most_periods = 10;
constexpr int most_fitting = 20;
constexpr int lost_by_a_misfit = 5;

std::uint32_t periods_in(std::uint32_t time_us) { return (time_us + period_us / 2) / period_us; }

bool is_whole_periods(std::uint32_t time_us) {
  const std::uint32_t periods = periods_in(time_us);
  const std::uint32_t nearest_us = periods * period_us;
  const std::uint32_t off_us = std::max(time_us, nearest_us) - std::min(time_us, nearest_us);
  return periods >= 1 && periods <= most_periods && off_us <= periods * most_off_us;
}

}  // namespace

bool SampleEdges::take(EdgeTimer::Edge edge, bool others) {
  const bool fits = is_whole_periods(edge - last_) && (!others || periods_in(edge - last_) > 1);
  last_ = edge;
  const int fitting = fits ? std::min(fitting_ + 1, most_fitting) : std::max(fitting_ - lost_by_a_misfit, 0);
  fitting_ = static_cast<std::uint8_t>(fitting);
  without_ = trusted() ? std::uint8_t{0} : static_cast<std::uint8_t>(std::min<int>(without_ + 1, most_without));
  return fits && trusted();
}

}  // namespace fantail::hal::stm32f4
