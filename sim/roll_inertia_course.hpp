// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <map>

#include "sim/burning_rocket.hpp"
#include "sim/vehicle.hpp"

namespace fantail::sim {

/// Roll inertia in kg m2 over time in s: straight in between, as the first before it and as the last behind it.
using RollInertiaCourse = std::map<double, double>;

/// Of one that is not empty.
[[nodiscard]] inline double roll_inertia_kg_m2(const RollInertiaCourse& course, double time_s) {
  const auto after = course.lower_bound(time_s);
  if (after == course.begin() || after == course.end()) {
    return after == course.end() ? course.rbegin()->second : after->second;
  }
  const auto before = std::prev(after);
  return before->second + (time_s - before->first) / (after->first - before->first) * (after->second - before->second);
}

/// From ignition to burn-out, as flown in six degrees of freedom. Empty: it stays what it is at lift-off.
[[nodiscard]] inline RollInertiaCourse roll_inertia_course(const Vehicle& vehicle) {
  constexpr int parts = 40;
  const double impulse_n_s = vehicle.motor.impulse_n_s();
  if (!vehicle.airframe || !vehicle.airframe->roll_inertia_after_burnout_kg_m2 || impulse_n_s <= 0.0) {
    return {};
  }
  RollInertiaCourse course;
  for (int i = 0; i <= parts; ++i) {
    const double time_s = vehicle.motor.burnout_s() * i / parts;
    course[time_s] = burning_rocket(*vehicle.airframe,
                                    {.mass_kg = vehicle.mass_kg,
                                     .propellant_kg = vehicle.motor.propellant_kg(),
                                     .roll_inertia_kg_m2 = vehicle.roll_plant.inertia_kg_m2},
                                    vehicle.motor.at(time_s).impulse_n_s / impulse_n_s)
                         .inertia.roll_kg_m2;
  }
  return course;
}

}  // namespace fantail::sim
