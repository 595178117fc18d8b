// SPDX-License-Identifier: MIT
#include "campaign/write_flight.hpp"

#include <utility>

#include "fly/fly_scenario.hpp"
#include "report/results.hpp"

namespace fantail::campaign {

void write_flight(const sim::Scenario& scenario, std::vector<std::string> changes, std::string note,
                  const std::filesystem::path& folder) {
  flight::Flight flight = fly::fly_scenario(scenario, {}, {}, fly::Log::kept);
  flight.changes = std::move(changes);
  flight.notes.insert(flight.notes.begin(), std::move(note));
  report::write_results(flight, report::results(flight), folder);
}

}  // namespace fantail::campaign
