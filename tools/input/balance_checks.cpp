// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "input/file_checks.hpp"
#include "input/messages.hpp"
#include "input/section.hpp"

namespace fantail::input {
namespace {

constexpr double a_millimetre_m = 0.001;  // to which a centre of gravity is measured

// What has left is the propellant, and it lay between nose and tail.
void check_propellant(const Section& section, const sim::Airframe& airframe, double full_kg, double propellant_kg) {
  const double moment_kg_m = full_kg * airframe.at_liftoff.centre_of_gravity_m;
  const double empty_kg = full_kg - propellant_kg;
  const double least_m = std::max(0.0, (moment_kg_m - propellant_kg * airframe.length_m) / empty_kg);
  const double most_m = std::min(airframe.length_m, moment_kg_m / empty_kg);
  const double after_m = airframe.after_burnout.centre_of_gravity_m;
  if (after_m < least_m - a_millimetre_m || after_m > most_m + a_millimetre_m) {
    section.refuse("centre_of_gravity_after_burnout_m", "= " + plain_number(after_m) + "; allowed: " + about(least_m) +
                                                            " to " + about(most_m) + ", as the propellant, " +
                                                            about(propellant_kg) + " kg, lies between nose and tail");
  }
}

// The least that any rocket has whose centre of gravity moves so: propellant and the rest each in one place.
void check_distance(const Section& section, const sim::Airframe& airframe, double full_kg, double propellant_kg,
                    double roll_inertia_kg_m2) {
  const double moved_m = std::abs(airframe.at_liftoff.centre_of_gravity_m - airframe.after_burnout.centre_of_gravity_m);
  const double surely_m = std::max(0.0, moved_m - a_millimetre_m);
  const double least_kg_m2 =
      0.5 * roll_inertia_kg_m2 + full_kg * (full_kg - propellant_kg) / propellant_kg * surely_m * surely_m;
  const double inertia_kg_m2 = airframe.at_liftoff.transverse_inertia_kg_m2;
  if (inertia_kg_m2 < least_kg_m2) {
    section.refuse("transverse_inertia_kg_m2", "= " + plain_number(inertia_kg_m2) + "; allowed: at least " +
                                                   about(least_kg_m2) + ", as the centre of gravity moves by " +
                                                   about(1e3 * moved_m) +
                                                   " mm until burn-out: the propellant is so far from the rest");
  }
}

struct State {
  const char* key;
  const sim::Airframe::MassProperties& mass;
  double mass_kg;
  double roll_inertia_kg_m2;
};

// About an axis across, each piece of mass counts with its distance along the rocket and with half of what it has about
// the long axis, because the rocket is the same all around. The distances are largest with all mass at nose and tail.
void check_inertia(const Section& section, const State& state, double length_m) {
  const double inertia_kg_m2 = state.mass.transverse_inertia_kg_m2;
  const double half_roll_kg_m2 = 0.5 * state.roll_inertia_kg_m2;
  const double place_m = state.mass.centre_of_gravity_m;
  const double most_kg_m2 = half_roll_kg_m2 + state.mass_kg * place_m * (length_m - place_m);
  if (inertia_kg_m2 > most_kg_m2) {
    section.refuse(state.key, "= " + plain_number(inertia_kg_m2) + "; allowed: at most " + about(most_kg_m2) +
                                  ", with all of the " + about(state.mass_kg) + " kg at nose and tail");
  }
}

}  // namespace

void check_balance(const Document& document, const sim::Vehicle& vehicle) {
  const Section section{document, "airframe"};
  const sim::Airframe& airframe = *vehicle.airframe;
  const double full_kg = vehicle.mass_kg;
  const double propellant_kg = vehicle.motor.propellant_kg();
  const double roll_kg_m2 = vehicle.roll_plant.inertia_kg_m2;
  if (vehicle.recovery && vehicle.recovery->position_m > airframe.length_m) {
    Section{document, "recovery"}.refuse("position_m", "= " + plain_number(vehicle.recovery->position_m) +
                                                           "; allowed: 0 to " + about(airframe.length_m) +
                                                           " m, the length of the rocket");
  }
  check_propellant(section, airframe, full_kg, propellant_kg);
  check_inertia(section, {"transverse_inertia_kg_m2", airframe.at_liftoff, full_kg, roll_kg_m2}, airframe.length_m);
  check_inertia(section,
                {"transverse_inertia_after_burnout_kg_m2", airframe.after_burnout, full_kg - propellant_kg,
                 airframe.roll_inertia_after_burnout_kg_m2.value_or(roll_kg_m2)},
                airframe.length_m);
  check_distance(section, airframe, full_kg, propellant_kg, roll_kg_m2);
}

}  // namespace fantail::input
