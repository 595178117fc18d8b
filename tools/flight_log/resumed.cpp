// SPDX-License-Identifier: MIT
#include <algorithm>

#include "flight_log/flight_log.hpp"

// Flights of which the processor was reset: each part has a record of its own.
namespace fantail::flight_log {

std::optional<protocol::LogEvent> resumed(const Flight& flight) {
  const auto found = std::ranges::find(flight.events, protocol::LogEventKind::resumed, &protocol::LogEvent::kind);
  return found == flight.events.end() ? std::nullopt : std::optional{*found};
}

// The board's clock goes on in flight, and a flight is resumed with its own plan only.
bool is_rest_of(const Flight& flight, const Flight& before) {
  return resumed(flight) && flight.has_header && before.has_header && flight.plan_block == before.plan_block &&
         flight.power_up > before.power_up && flight.first_time > before.last_time;
}

bool is_one_flight(const LogFile& file) {
  return !file.flights.empty() &&
         std::all_of(file.flights.begin(), file.flights.end() - 1, [](const Flight& flight) { return flight.goes_on; });
}

}  // namespace fantail::flight_log
