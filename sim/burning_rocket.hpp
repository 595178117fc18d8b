// SPDX-License-Identifier: MIT
#pragma once

#include "sim/airframe.hpp"
#include "sim/rigid_body.hpp"

namespace fantail::sim {

/// A rocket with its motor, at lift-off.
struct FullRocket {
  double mass_kg = 0.0;  ///< propellant included; above that of the propellant
  double propellant_kg = 0.0;
  double roll_inertia_kg_m2 = 0.0;
};

/// Where the mass of a rocket is once a share of its propellant (0 to 1) has burnt.
struct BurningRocket {
  Inertia inertia;
  double centre_of_gravity_m;  ///< from the tip of the nose
};

/// Mass and first moment follow the propellant; so does the inertia about the centre of gravity, which is an
/// approximation.
[[nodiscard]] inline BurningRocket burning_rocket(const Airframe& airframe, const FullRocket& full, double burnt) {
  const auto between = [burnt](double at_liftoff, double after_burnout) {
    return at_liftoff + burnt * (after_burnout - at_liftoff);
  };
  const double mass_kg = full.mass_kg - full.propellant_kg * burnt;
  const double moment_kg_m = between(full.mass_kg * airframe.at_liftoff.centre_of_gravity_m,
                                     (full.mass_kg - full.propellant_kg) * airframe.after_burnout.centre_of_gravity_m);
  return {.inertia = {.mass_kg = mass_kg,
                      .transverse_kg_m2 = between(airframe.at_liftoff.transverse_inertia_kg_m2,
                                                  airframe.after_burnout.transverse_inertia_kg_m2),
                      .roll_kg_m2 = between(full.roll_inertia_kg_m2, airframe.roll_inertia_after_burnout_kg_m2.value_or(
                                                                         full.roll_inertia_kg_m2))},
          .centre_of_gravity_m = moment_kg_m / mass_kg};
}

}  // namespace fantail::sim
