// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "flight_log/flight_log.hpp"

namespace fantail::flight_log {

/// How long the ticks of a flight took, and how regularly they came.
struct LoopTimes {
  std::size_t ticks = 0;  ///< whose duration is known: each stands in the tick after it
  double mean_us = 0.0;
  double p99_us = 0.0;  ///< the smallest duration that 99 of 100 ticks do not exceed
  double longest_us = 0.0;
  std::size_t late = 0;          ///< ticks that took a millisecond or more, and so delayed the next
  double longest_step_us = 0.0;  ///< between the beginnings of two ticks with no gap between them
};

/// Empty for a flight without ticks of this version.
[[nodiscard]] std::optional<LoopTimes> loop_times(const Flight& flight);

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
