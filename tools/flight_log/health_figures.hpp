// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "flight_log/flight_log.hpp"

namespace fantail::flight_log {

/// The worst of what the health records of a flight say. Counters run from power-up; these are what came to them while
/// the flight was recorded.
struct HealthFigures {
  std::uint32_t longest_tick_us = 0;
  std::uint32_t longest_queue = 0;
  std::uint32_t ticks_dropped = 0;
  std::uint32_t unsent = 0;
  std::uint32_t bus_errors = 0;
};

/// Empty without a health record.
[[nodiscard]] std::optional<HealthFigures> health_figures(const Flight& flight);

}  // namespace fantail::flight_log
