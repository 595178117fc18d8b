// SPDX-License-Identifier: MIT
#include "rules/judge.hpp"

namespace fantail::rules {
namespace {

std::string without_control(const flight::Flight& flight) {
  return flight.events.control_start_s ? "" : ", in which control never began";
}

}  // namespace

Subject subject_of(const sim::Scenario& scenario, const flight::Flight& flight) {
  Subject subject{.what = scenario.name + (scenario.changed_values == 0 ? ", " : " with other values, ") +
                          "its plan and one simulated flight" +
                          (scenario.faults.empty() ? "" : " with the faults of the scenario") + without_control(flight),
                  .found = of_rocket(scenario, flight),
                  .why_missing = "neither plan nor simulation tells it"};
  subject.found.merge(of_flight(flight, scenario.atmosphere));
  subject.found.merge(of_plan(scenario.plan));
  subject.found.merge(of_law());
  return subject;
}

}  // namespace fantail::rules
