// SPDX-License-Identifier: MIT
#include "listen/pad.hpp"

#include <algorithm>
#include <numeric>

namespace fantail::listen {

std::optional<double> pad_mean(const Heard& heard, const Signal& signal) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < signal.time_s.size() && (!heard.lift_off_s || signal.time_s[i] < *heard.lift_off_s - 0.1);
       ++i) {
    sum += signal.value[i];
    count += 1.0;
  }
  return count > 0.0 ? std::optional{sum / count} : std::nullopt;
}

std::optional<Rest> at_rest(const Heard& heard, const Signal& axial) {
  if (const auto mean = heard.lift_off_s ? pad_mean(heard, axial) : std::nullopt) {
    return Rest{*mean, "Before lift-off"};
  }
  constexpr double most_s = 1.0;
  constexpr double hold_s = 0.3;
  double until_s = heard.log.begin_s() + most_s;
  for (const Event& event : heard.events) {
    until_s = event.to == core::Phase::launched ? std::min(until_s, event.time_s - hold_s) : until_s;
  }
  const auto count = std::ranges::lower_bound(axial.time_s, until_s) - axial.time_s.begin();
  if (count == 0) {
    return std::nullopt;
  }
  const double sum = std::accumulate(axial.value.begin(), axial.value.begin() + count, 0.0);
  return Rest{sum / static_cast<double>(count),
              until_s < heard.log.begin_s() + most_s ? "Before the first detection" : "In its first second"};
}

}  // namespace fantail::listen
