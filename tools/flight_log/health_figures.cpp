// SPDX-License-Identifier: MIT
#include "flight_log/health_figures.hpp"

#include <algorithm>

namespace fantail::flight_log {

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
