// SPDX-License-Identifier: MIT
#include "flight_log/flight_figures.hpp"

#include <algorithm>
#include <numeric>

namespace fantail::flight_log {
namespace {

constexpr core::Microseconds tick_period{1'000};

// Whether a record is missing between these two.
bool gap_between(const Flight& flight, std::uint32_t before, std::uint32_t after) {
  const auto next = std::ranges::upper_bound(flight.gaps, before, {}, &Gap::first_missing);
  return next != flight.gaps.end() && next->first_missing < after;
}

double longest_step(const Flight& flight) {
  core::Microseconds longest{};
  for (std::size_t i = 1; i < flight.ticks.size(); ++i) {
    const core::Microseconds step = flight.ticks[i].tick.time - flight.ticks[i - 1].tick.time;
    if (step > longest && !gap_between(flight, flight.ticks[i - 1].sequence, flight.ticks[i].sequence)) {
      longest = step;
    }
  }
  return static_cast<double>(longest.count());
}

}  // namespace

std::optional<LoopTimes> loop_times(const Flight& flight) {
  std::vector<std::int64_t> durations;
  durations.reserve(flight.ticks.size());
  for (const LoggedTick& logged : flight.ticks) {
    durations.push_back(logged.tick.duration_before.count());
  }
  if (durations.empty()) {
    return std::nullopt;
  }
  const std::int64_t sum = std::accumulate(durations.begin(), durations.end(), std::int64_t{0});
  const auto late = std::ranges::count_if(durations, [](std::int64_t us) { return us >= tick_period.count(); });
  // The smallest with at least 99 % of all at or below it.
  const std::size_t rank = (99 * durations.size() + 99) / 100 - 1;
  std::ranges::nth_element(durations, durations.begin() + static_cast<std::ptrdiff_t>(rank));
  return LoopTimes{.ticks = durations.size(),
                   .mean_us = static_cast<double>(sum) / static_cast<double>(durations.size()),
                   .p99_us = static_cast<double>(durations[rank]),
                   .longest_us = static_cast<double>(*std::ranges::max_element(durations)),
                   .late = static_cast<std::size_t>(late),
                   .longest_step_us = longest_step(flight)};
}

std::optional<HealthFigures> health_figures(const Flight& flight) {
  if (flight.health.empty()) {
    return std::nullopt;
  }
  const protocol::LogHealth& first = flight.health.front();
  const protocol::LogHealth& last = flight.health.back();
  HealthFigures figures{.ticks_dropped = last.ticks_dropped - first.ticks_dropped,
                        .unsent = last.unsent - first.unsent,
                        .bus_errors = last.bus_errors - first.bus_errors};
  for (const protocol::LogHealth& health : flight.health) {
    figures.longest_tick_us = std::max<std::uint32_t>(figures.longest_tick_us, health.longest_tick_us);
    figures.longest_queue = std::max<std::uint32_t>(figures.longest_queue, health.longest_queue);
  }
  return figures;
}

}  // namespace fantail::flight_log
