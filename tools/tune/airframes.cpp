// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/random.hpp"
#include "tune/flights.hpp"

namespace fantail::tune {

sim::Scenario with_airframe(sim::Scenario scenario, double damping_factor, double torque_factor) {
  scenario.vehicle.roll_plant.damping_m2 *= damping_factor;
  scenario.vehicle.roll_plant.torque_m *= torque_factor;
  return scenario;
}

std::vector<sim::Scenario> corners(const sim::Scenario& scenario, double spread) {
  std::vector<sim::Scenario> all{scenario};
  if (spread > 1.0) {
    for (const double damping : {1.0 / spread, spread}) {
      for (const double torque : {1.0 / spread, spread}) {
        all.push_back(with_airframe(scenario, damping, torque));
      }
    }
  }
  return all;
}

std::vector<sim::Scenario> corners_and_middles(const sim::Scenario& scenario, double spread) {
  std::vector<sim::Scenario> all = corners(scenario, spread);
  if (spread > 1.0) {
    for (const double factor : {1.0 / spread, spread}) {
      all.push_back(with_airframe(scenario, factor, 1.0));
      all.push_back(with_airframe(scenario, 1.0, factor));
    }
  }
  return all;
}

sim::Scenario drawn(const sim::Scenario& scenario, double spread, std::uint64_t seed) {
  constexpr std::uint64_t stream = 0x74756e65;  // of no other random number of a flight
  sim::Random random{seed, stream};
  const double damping = std::pow(spread, 2.0 * random.uniform() - 1.0);
  const double torque = std::pow(spread, 2.0 * random.uniform() - 1.0);
  sim::Scenario changed = with_airframe(scenario, damping, torque);
  changed.seed = seed;
  return changed;
}

}  // namespace fantail::tune
