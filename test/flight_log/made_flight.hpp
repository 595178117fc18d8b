// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/flight_plan.hpp"
#include "core/tick_record.hpp"
#include "flight_log/flight_log.hpp"

namespace fantail::flight_log {

/// A flight that was flown by the flight law on made-up sensor readings, and its log.
struct MadeFlight {
  std::vector<std::byte> bytes;
  std::vector<core::TickRecord> records;  ///< of the logged ticks
  std::vector<std::size_t> frame_ends;    ///< where each record of the log ends
  core::FlightPlan plan;
};

struct MadeFlightOptions {
  std::uint32_t flight = 1;
  core::Microseconds length{3'000'000};  ///< logged; the first half second of it on the pad
  core::Microseconds checkpoint_every{500'000};
  core::Microseconds header_every{1'000'000};
  bool ended = true;  ///< says so in its last record
};

/// Stands for six seconds, pushes with 8 g for two, then falls; rolls at half a radian a second, whatever it commands.
[[nodiscard]] MadeFlight make_flight(const MadeFlightOptions& options = {});

}  // namespace fantail::flight_log
