// SPDX-License-Identifier: MIT
#include "stability/canard_sense.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/canard_aerodynamics.hpp"
#include "sim/deflection_range.hpp"

namespace fantail::stability {
namespace {

// Of what healthy canards do. Servos that differ a little do not cancel to zero.
constexpr double hardly = 0.05;
constexpr const char* direction_differs = " (direction differs between plan and vehicle)";

/// Where the plan shares, others may do the work of two canards that faults have turned.
sim::CanardResponse response_for_certain(const sim::Scenario& scenario) {
  constexpr std::size_t most_shared = 2;
  const sim::CanardResponse with_faults = sim::canard_response(scenario);
  if (scenario.faults.empty() || scenario.plan.run.canard_fault != core::CanardFaultPolicy::share) {
    return with_faults;
  }
  sim::Scenario healthy = scenario;
  healthy.faults.clear();
  const sim::CanardResponse without = sim::canard_response(healthy);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    changed += with_faults.of_each[i] == without.of_each[i] ? 0U : 1U;
  }
  return changed <= most_shared ? without : with_faults;
}

/// "canards 1, 2 and 4 turn"
std::string named(const std::vector<std::size_t>& numbers) {
  if (numbers.size() == core::canard_count) {
    return "all canards turn";
  }
  std::string text = numbers.size() == 1 ? "canard " : "canards ";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + std::to_string(numbers[i]);
  }
  return text + (numbers.size() == 1 ? " turns" : " turn");
}

/// The numbers of the canards whose direction differs between plan and vehicle, in order.
std::vector<std::size_t> with_other_directions(const sim::Scenario& scenario) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const bool is_reversed_in_plan = scenario.plan.canards.each[i].direction == core::Direction::reversed;
    if (is_reversed_in_plan != scenario.vehicle.canards[i].reversed) {
      numbers.push_back(i + 1);
    }
  }
  return numbers;
}

}  // namespace

double left_in_the_end(const sim::Scenario& scenario) {
  const double against = static_cast<double>(with_other_directions(scenario).size()) / core::canard_count;
  return (1.0 - 2.0 * against) * sim::left_by_fins(scenario.vehicle.canard_air);
}

std::string works_against(const sim::Scenario& scenario) {
  const std::vector<std::size_t> numbers = with_other_directions(scenario);
  return numbers.size() == 1 ? named(numbers) + " the rocket against the roll command" + direction_differs +
                                   ", so the canards have half of their torque"
                             : "";
}

std::string why_uncontrollable(const sim::Scenario& scenario) {
  const sim::CanardResponse response = response_for_certain(scenario);
  if (response.effectiveness > hardly) {
    return sim::left_by_fins(scenario.vehicle.canard_air) > 0.0
               ? ""
               : "the fins take back all of the canards' roll torque, or more";
  }
  std::vector<std::size_t> against;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (response.of_each[i] < 0.0) {
      against.push_back(i + 1);
    }
  }
  if (against.empty()) {
    return "the canards hardly follow the roll command, or not at all";
  }
  return named(against) + " the rocket against the roll command" +
         (against.size() < core::canard_count ? ", and the others hardly outweigh that, or not at all" : "") +
         (std::ranges::includes(with_other_directions(scenario), against) ? direction_differs : "");
}

}  // namespace fantail::stability
